namespace Nowpose.Cli.Sessions;

/// <summary>A message with joint positions as it was received.</summary>
/// <param name="Positions">rad or m, one per name.</param>
/// <param name="Velocities">rad/s or m/s, one per name, NaN where absent; null when none is known.</param>
/// <param name="Accelerations">rad/s² or m/s², likewise.</param>
/// <param name="Dropped">Why it was of no use to the session; null when it was.</param>
/// <param name="ControlArrival">When it arrived at the gateway that recorded it; null in a headset's recording.</param>
sealed record SampleLine(
    HeadsetTime Arrival, ControlTime Stamp, string[] Names, double[] Positions, double[] Velocities, double[] Accelerations,
    string Dropped, ControlTime? ControlArrival = null) : SessionLine;
