using System.Text;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// Reads the valid transforms or signals of a message on /tf, /tf_static or /signals that also contains invalid ones, for example a tracker's pose of an
/// object that it has lost. Not thread-safe.
/// </summary>
/// <remarks>
/// Each transform or signal is read as a message of its own, so that the rules are those of <see cref="RosbridgeReader"/>. The parts together are not much
/// longer than the message, so that a large message with many faults needs little time.
/// </remarks>
sealed class PartialCellMessage
{
    static readonly JsonNames Envelope = new("msg"), Transforms = new("transforms"), Signals = new("header", "name", "value"),
        Stamp = new("stamp"), Child = new("child_frame_id");

    /// <summary>Maximum length of a stamp, in bytes. It is repeated for each signal.</summary>
    const int MaxStampBytes = 256;

    readonly RosbridgeReader _reader = new();

    /// <summary>Reads the valid parts of a rejected message.</summary>
    /// <param name="utf8">The complete message, which is JSON.</param>
    /// <param name="message">The envelope of the message; receives the valid transforms or signals.</param>
    /// <param name="leftOut">
    /// Receives the invalid transforms or signals. Receives none if the message as a whole is invalid, for example because it has too many.
    /// </param>
    /// <returns>Whether at least one transform or signal is valid.</returns>
    public bool TryRead(ReadOnlySpan<byte> utf8, RosbridgeMessage message, List<LeftOut> leftOut)
    {
        var isSignal = message.Topic == RosTopics.Signals;
        var parts = utf8.Length > ProtocolLimits.MessageBytes ? [] : isSignal ? SignalsIn(utf8) : TransformsIn(utf8);
        var names = parts.ConvertAll(part => part.Name);
        var kind = CellKinds.Of(message.Topic);
        var (transforms, signals, known) = (new TransformsMessage(), (SignalsMessage)null, new HashSet<string>());
        for (var i = 0; i < parts.Count; i++)
        {
            var isTwice = names[i].Length > 0 && names.FindAll(name => name == names[i]).Count > 1;
            if (isTwice && !known.Add(names[i])) continue;
            var text = $"{{\"op\":\"publish\",\"topic\":\"{message.Topic}\",\"msg\":{parts[i].Body}}}";
            var isValid = _reader.TryRead(Encoding.UTF8.GetBytes(text), out var part, out var reason) && !isTwice;
            if (isTwice) reason = DropReason.DuplicateName;
            if (!isValid) leftOut.Add(new LeftOut(reason, names[i], InvalidCellMessage.Describe(parts[i].Body, names[i], kind, reason)));
            else if (isSignal) (signals ??= new SignalsMessage(part.Signals.Stamp)).Add(part.Signals[0]);
            else transforms.Add(part.Transforms[0]);
        }

        message.Signals = signals;
        message.Transforms = transforms.Count > 0 ? transforms : null;
        return signals != null || transforms.Count > 0;
    }

    // Returns the name of each transform, empty if it is invalid, and the body of a message with only this transform.
    static List<(string Name, string Body)> TransformsIn(ReadOnlySpan<byte> utf8)
    {
        var json = BodyOf(utf8);
        var seen = 0;
        List<string> elements = [];
        json.BeginObject();
        while (json.NextField(Transforms, ref seen, out _)) elements = Elements(ref json);
        return json.Fault == DropReason.None && elements.Count <= ProtocolLimits.Frames ? elements.ConvertAll(one => (ChildIn(one), $"{{\"transforms\":[{one}]}}")) : [];
    }

    // Returns the name of each signal, empty if it is invalid, and the body of a message with only this signal.
    static List<(string Name, string Body)> SignalsIn(ReadOnlySpan<byte> utf8)
    {
        var json = BodyOf(utf8);
        var seen = 0;
        var stamp = "null";
        List<string> names = [], values = [];
        json.BeginObject();
        while (json.NextField(Signals, ref seen, out var field))
        {
            if (field == 0) stamp = StampIn(ref json);
            else if (field == 1) names = Elements(ref json);
            else values = Elements(ref json);
        }

        if (json.Fault != DropReason.None || names.Count > ProtocolLimits.Signals || stamp.Length > MaxStampBytes) return [];
        // With another number of values than names, it is unknown which value belongs to which signal, so each part has no value.
        string ValueOf(int index) => names.Count == values.Count ? values[index] : "";
        return [.. names.Select((name, i) => (NameIn(name), $"{{\"header\":{{\"stamp\":{stamp}}},\"name\":[{name}],\"value\":[{ValueOf(i)}]}}"))];
    }

    static string StampIn(ref JsonUtf8Reader json)
    {
        var seen = 0;
        var stamp = "null";
        json.BeginObject();
        while (json.NextField(Stamp, ref seen, out _)) stamp = Text(ref json);
        return stamp;
    }

    static string ChildIn(string transform)
    {
        var json = new JsonUtf8Reader(Encoding.UTF8.GetBytes(transform), ProtocolLimits.Nesting);
        var seen = 0;
        string name = null;
        json.BeginObject();
        while (json.NextField(Child, ref seen, out _)) name = NameIn(ref json);
        return name ?? "";
    }

    static string NameIn(string element)
    {
        var json = new JsonUtf8Reader(Encoding.UTF8.GetBytes(element), ProtocolLimits.Nesting);
        return NameIn(ref json);
    }

    static string NameIn(ref JsonUtf8Reader json) => json.Text(out var name) && name.Length <= ProtocolLimits.NameLength ? name : "";

    // Returns a reader at the start of the message's body.
    static JsonUtf8Reader BodyOf(ReadOnlySpan<byte> utf8)
    {
        var json = new JsonUtf8Reader(utf8, ProtocolLimits.Nesting);
        var seen = 0;
        json.BeginObject();
        json.NextField(Envelope, ref seen, out _);
        return json;
    }

    static List<string> Elements(ref JsonUtf8Reader json)
    {
        List<string> elements = [];
        json.BeginArray();
        while (json.NextElement()) elements.Add(Text(ref json));
        return elements;
    }

    static string Text(ref JsonUtf8Reader json)
    {
        var start = json.Position;
        json.Skip();
        return Encoding.UTF8.GetString(json.Since(start));
    }
}
