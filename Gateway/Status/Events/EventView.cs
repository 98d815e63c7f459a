namespace Nowpose.Gateway.Status.Events;

/// <summary>An event as /operations/state and /operations/events write it.</summary>
/// <param name="Level">ok, warning or error.</param>
/// <param name="UntilUtc">Null while it lasts.</param>
/// <param name="Text">What is wrong, where, why and what to do, in plain words.</param>
sealed record EventView(
    long Id, string Kind, string Which, string What, string Reason, string Level, string SinceUtc, string UntilUtc, string Text = null);
