export const pendulum = {
  amplitude: "amplitude",
} as const;
