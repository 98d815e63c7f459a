using Nowpose.Session;

namespace Nowpose.Cli.Sessions;

/// <summary>A message of set-points as it was received.</summary>
/// <param name="Dropped">Why it was of no use to the session; null when it could be.</param>
sealed record PlanLine(PlanArrival Arrival, string Dropped) : SessionLine;
