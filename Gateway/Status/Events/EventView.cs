namespace Nowpose.Gateway.Status.Events;

/// <summary>An event as sent by /operations/state and /operations/events.</summary>
/// <param name="Level">ok, warning or error.</param>
/// <param name="UntilUtc">End of the event; null while it lasts.</param>
/// <param name="Text">The fault with its place, reason and remedy as text.</param>
sealed record EventView(
    long Id, string Kind, string Which, string What, string Reason, string Level, string SinceUtc, string UntilUtc, string Text = null);
