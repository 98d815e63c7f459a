using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Cli.SessionFiles;

/// <summary>A received message of set-points.</summary>
/// <param name="Dropped">Reason why the session dropped the message; null if it was used.</param>
sealed record PlanLine(Arrival<JointTrajectoryMessage> Arrival, string Dropped) : SessionLine;
