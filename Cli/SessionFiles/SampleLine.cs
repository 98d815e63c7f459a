namespace Nowpose.Cli.SessionFiles;

/// <summary>A received message of joint positions.</summary>
/// <param name="Positions">Positions in rad or m, one per name.</param>
/// <param name="Velocities">Velocities in rad/s or m/s, one per name, NaN if unknown; null if all are unknown.</param>
/// <param name="Accelerations">Accelerations in rad/s² or m/s², one per name, NaN if unknown; null if all are unknown.</param>
/// <param name="Dropped">Reason why the session dropped the sample; null if it was used.</param>
/// <param name="ControlArrival">Arrival time at the recording gateway; null in a headset's recording.</param>
sealed record SampleLine(
    HeadsetTime Arrival, ControlTime Stamp, string[] Names, double[] Positions, double[] Velocities, double[] Accelerations,
    string Dropped, ControlTime? ControlArrival = null) : SessionLine;
