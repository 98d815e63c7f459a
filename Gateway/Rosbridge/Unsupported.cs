using System.Text;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Finds options of a rosbridge request that the gateway does not support and ignores.</summary>
static class Unsupported
{
    const int MaxLength = 32;

    static readonly JsonNames Options = new("compression", "fragment_size", "latch", "qos");

    /// <summary>Whether a publication may have such an option. Needs less time than <see cref="In"/>, for messages that arrive often.</summary>
    public static bool MayBeIn(ReadOnlySpan<byte> text, RosbridgeMessage publication) =>
        publication.Type != null || text.IndexOf("compression"u8) >= 0 || text.IndexOf("fragment_size"u8) >= 0;

    /// <summary>Gets one warning for the client for each unsupported option of the request.</summary>
    /// <param name="text">The complete request, which was read before.</param>
    public static List<string> In(ReadOnlySpan<byte> text, RosbridgeMessage request)
    {
        List<string> warnings = [];
        var json = new JsonUtf8Reader(text, ProtocolLimits.Nesting);
        var seen = 0;
        json.BeginObject();
        while (json.NextField(Options, ref seen, out var option))
            if (Value(ref json) is { } value && WarningOf(Options[option], Short(value), request) is { } warning) warnings.Add(warning);
        if (request.Op == RosbridgeOp.Subscribe && request.QueueLength > Subscription.MaxQueueLength)
            warnings.Add(RequestMessages.QueueLength(request.QueueLength, Subscription.MaxQueueLength));
        if (request.Op == RosbridgeOp.Publish && !Publications.HasType(request.RobotTopic, request.Type))
            warnings.Add(RequestMessages.PublishedType(Publications.TypeOf(request.RobotTopic), RequestText.Short(request.Type)));
        return warnings;
    }

    static string WarningOf(string option, string value, RosbridgeMessage request) => option switch
    {
        "compression" => value is "none" or "" ? null : RequestMessages.Compression(value),
        "fragment_size" => RequestMessages.FragmentSize(value),
        "qos" => RequestMessages.Qos,
        _ => request.Op == RosbridgeOp.Advertise && value == "true" && !Publications.IsKept(request.RobotTopic) ? RequestMessages.Latch(request.Topic) : null,
    };

    // Returns a value as text; null for JSON null.
    static string Value(ref JsonUtf8Reader json)
    {
        if (json.TakeNull()) return null;
        if (json.IsText && json.Text(out var text)) return text;
        var start = json.Position;
        json.Skip();
        return Encoding.UTF8.GetString(json.Since(start));
    }

    static string Short(string value) => InputException.OneLine(value, MaxLength);
}
