using System.Globalization;

namespace Nowpose.Gateway.Status.Events;

enum Level
{
    Warning,
    Error,
}

/// <summary>A fault that exists at present.</summary>
/// <param name="Kind">The category: joint, frame, signal, adapter, clock, headset, recording, source, description, limit, connection, certificate or file.</param>
/// <param name="Which">Name of the joint, adapter, headset, topic, port, address or file.</param>
/// <param name="What">Predicate of a sentence whose subject is the kind and the name, for example "is refused".</param>
/// <param name="Reason">The reason; may be empty, and may change while the condition lasts.</param>
/// <param name="Blocks">Whether the gateway is not ready while the condition lasts.</param>
/// <param name="Since">Start of the condition; null if it is unknown.</param>
sealed record Condition(
    string Kind, string Which, string What, string Reason, Level Level, bool Blocks = false, DateTimeOffset? Since = null)
{
    /// <summary>The fault and its place as one clause, in one line.</summary>
    public string Headline { get => OneLine(field ?? $"{Kind} {Which} {What}"); init; }

    /// <summary>Instruction for the operator as a sentence; empty if the reason contains it.</summary>
    public string Remedy { get; init; } = "";

    /// <summary>Whether the condition is normal for a short time after this start, see <see cref="Age"/>.</summary>
    public bool IsNormalAtStart { get; init; }

    /// <summary>
    /// Time since the start of the client that reports the condition, or since it connected to its plant; null for the time since the start of the
    /// gateway.
    /// </summary>
    public TimeSpan? Age { get; init; }

    /// <summary>Identifies the event. Conditions with the same key belong to the same event.</summary>
    public (string, string, string) Key => (Kind, Which, What);

    /// <summary>The fault, its reason and the remedy in one line.</summary>
    public string Text => Compose("");

    /// <summary><see cref="Text"/> with the start of the condition.</summary>
    public string TextWithSince => Compose(
        Since is { } since ? $" (since {since.UtcDateTime.ToString("yyyy-MM-dd HH:mm:ss 'UTC'", CultureInfo.InvariantCulture)})" : "");

    // Names and reasons come from clients and can contain line ends.
    static string OneLine(string text) => InputException.OneLine(text, int.MaxValue);

    string Compose(string note)
    {
        var isLast = note.Length == 0 && Remedy.Length == 0;
        var reason = Reason.Length == 0 ? "" : $": {(isLast ? Reason : Reason.TrimEnd('.'))}";
        return Headline + OneLine(reason) + note + (Remedy.Length == 0 ? "" : $". {Remedy}");
    }
}
