namespace Nowpose.Gateway.Status.Events;

enum Level
{
    Ok,
    Warning,
    Error,
}

/// <summary>Something that is wrong at the moment.</summary>
/// <param name="Kind">One of few words: joint, adapter, clock, headset, recording, source, limit or certificate.</param>
/// <param name="Which">Name of the joint, adapter, headset or file.</param>
/// <param name="What">Predicate: "is refused".</param>
/// <param name="Reason">May be empty, and may change while the condition lasts.</param>
/// <param name="Blocks">Whether the gateway is not ready because of it.</param>
sealed record Condition(
    string Kind, string Which, string What, string Reason, Level Level, bool Blocks = false, DateTimeOffset? Since = null)
{
    /// <summary>Two conditions of the same key are the same event.</summary>
    public (string, string, string) Key => (Kind, Which, What);

    public string Text => Reason.Length == 0 ? $"{Kind} {Which} {What}" : $"{Kind} {Which} {What}: {Reason}";
}
