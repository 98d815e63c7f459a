namespace Nowpose.Gateway.Status.Joints;

/// <summary>
/// The words for the reason of a joint that is neither live nor at rest. They are label values of a metric, so the set is fixed. Each word has one
/// meaning; the reason itself is a sentence.
/// </summary>
static class JointFaultReasons
{
    /// <summary>Another source publishes the joint.</summary>
    public const string Taken = "taken";

    /// <summary>The adapter reports the joint as live or at rest, but no sample has arrived.</summary>
    public const string NoSample = "no-sample";

    /// <summary>Samples have stopped, and no adapter gives a reason.</summary>
    public const string SamplesStopped = "samples-stopped";

    /// <summary>The adapter has stopped reporting.</summary>
    public const string AdapterSilent = "adapter-silent";

    /// <summary>The robot description has the joint, but no source publishes it.</summary>
    public const string NotPublished = "not-published";

    /// <summary>The gateway drops the source's samples for a reason without its own word.</summary>
    public const string InvalidMessage = "invalid-message";

    /// <summary>The samples arrive with an unchanged time stamp.</summary>
    public const string StampNotNewer = "stamp-not-newer";

    /// <summary>The samples arrive with a time stamp that is too old.</summary>
    public const string StampOld = "stamp-old";

    /// <summary>The control clock does not run in real time, so no position of the joint is current.</summary>
    public const string ClockRate = "clock-rate";

    /// <summary>Any other reason, for example of an adapter that sends no word.</summary>
    public const string Other = "other";

    // The words of the adapters, which send them with the key reason/NAME or as the reason of a refused value.
    static readonly string[] OfAdapters =
    [
        "never-received", "not-connected", "node-gone", "not-monitored", "not-readable", "ended-in-motion", "silent-too-long", "not-confirmed",
        "retained", "plc-stopped", "other-gateway",
    ];

    // The words of the adapters for a value that has arrived and cannot be used.
    static readonly HashSet<string> OfValues =
    [
        "status-bad", "status-uncertain", "type", "index", "field", "malformed", "not-finite", "name-twice", "stamp-missing", "stamp-zero",
        StampNotNewer, "stamp-future", StampOld, "time-unmatched",
    ];

    /// <summary>All words.</summary>
    public static readonly IReadOnlySet<string> All =
        new HashSet<string>([.. OfAdapters, .. OfValues, Taken, NoSample, SamplesStopped, AdapterSilent, NotPublished, InvalidMessage, ClockRate, Other]);

    /// <summary>Whether a word means that a value has arrived and cannot be used.</summary>
    public static bool IsOfValue(string word) => word != null && OfValues.Contains(word);

    /// <summary>Gets the word itself if it is one of the set, and <see cref="Other"/> otherwise.</summary>
    /// <param name="word">The word of a client; null if it sends none.</param>
    public static string Of(string word) => word != null && All.Contains(word) ? word : Other;

    /// <summary>Gets the word for the reason for which the gateway drops a joint's samples.</summary>
    public static string Of(DropReason reason) => reason switch
    {
        DropReason.NotFinite => "not-finite",
        DropReason.StampZero => "stamp-zero",
        DropReason.StampInFuture => "stamp-future",
        DropReason.JointTaken => Taken,
        DropReason.None => Other,
        _ => InvalidMessage,
    };
}
