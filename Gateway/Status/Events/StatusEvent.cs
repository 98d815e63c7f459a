namespace Nowpose.Gateway.Status.Events;

/// <summary>A condition with its start and end.</summary>
/// <param name="Id">Number of the event, counted from 1 since the start of the gateway.</param>
/// <param name="Until">End of the event; null while it lasts.</param>
sealed record StatusEvent(long Id, Condition Condition, DateTimeOffset Since, DateTimeOffset? Until)
{
    /// <summary>
    /// Start of the event as a timestamp of the time provider. The difference of the two times is not the duration if the system clock was set in
    /// between.
    /// </summary>
    public long Began { get; init; }

    public EventView View => new(
        Id, Condition.Kind, Condition.Which, Condition.What, Condition.Reason, Condition.Level.ToString().ToLowerInvariant(), UtcText.Of(Since),
        Until is { } end ? UtcText.Of(end) : null, Condition.Text);
}
