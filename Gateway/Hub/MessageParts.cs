using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>Parts of messages: the accepted part, and parts that, written as JSON, do not exceed the maximum length of a message.</summary>
/// <remarks>
/// A received message may become longer when it is written again, because headers of ROS 1 have one more field and numbers may get more digits.
/// </remarks>
static class MessageParts
{
    /// <summary>Upper bound of the length of the JSON around the transforms or signals.</summary>
    const int EnvelopeBytes = 512;

    /// <summary>
    /// Upper bound of the length of a transform without its frame names: field names, a stamp, and seven numbers of up to 24 characters.
    /// </summary>
    const int TransformBytes = 400;

    /// <summary>Upper bound of the length of a signal without its name: quotation marks, separators, and a number.</summary>
    const int SignalBytes = 32;

    public static IEnumerable<TransformsMessage> Of(TransformsMessage message) => Divided(
        message, message.Count,
        i => TransformBytes + RosMessageWriter.MaxBytesOf(message[i].Child) + RosMessageWriter.MaxBytesOf(message[i].Parent), Part);

    public static IEnumerable<SignalsMessage> Of(SignalsMessage message) =>
        Divided(message, message.Count, i => SignalBytes + RosMessageWriter.MaxBytesOf(message[i].Name), Part);

    /// <summary>Gets the names of the frames or signals, or the cell-wide names of the joints, in a message; empty for other messages.</summary>
    public static IEnumerable<string> NamesIn(HubMessage message)
    {
        foreach (var joint in message.Joints ?? []) yield return joint;
        if (message.Content is TransformsMessage transforms)
            for (var i = 0; i < transforms.Count; i++) yield return transforms[i].Child;
        else if (message.Content is SignalsMessage signals)
            for (var i = 0; i < signals.Count; i++) yield return signals[i].Name;
    }

    /// <summary>Returns a message itself if all its frames or joints fulfil a condition; otherwise a message with those that do.</summary>
    /// <param name="message">A joint state or transforms.</param>
    /// <param name="isIn">The condition, for the name of a frame or the cell-wide name of a joint.</param>
    public static HubMessage Only(HubMessage message, Predicate<string> isIn)
    {
        if (message.Content is TransformsMessage transforms)
        {
            var part = Part(transforms, index => isIn(transforms[index].Child));
            return part.Count == transforms.Count ? message : message.With(part);
        }

        int[] kept = [.. Enumerable.Range(0, message.Joints.Length).Where(index => isIn(message.Joints[index]))];
        return kept.Length == message.Joints.Length
            ? message : message.With(Part((JointStateMessage)message.Content, kept), Array.ConvertAll(kept, index => message.Joints[index]));
    }

    /// <summary>Returns a message itself if it has only these joints; otherwise a message with these joints.</summary>
    /// <param name="names">Some of the names in the message, in their order.</param>
    public static JointStateMessage Part(JointStateMessage message, string[] names) => names.Length == message.Names.Length
        ? message : Part(message, Array.ConvertAll(names, name => Array.IndexOf(message.Names, name)));

    static JointStateMessage Part(JointStateMessage message, int[] kept)
    {
        T[] Kept<T>(T[] all) => all == null ? null : Array.ConvertAll(kept, index => all[index]);
        return new JointStateMessage(
            message.Stamp, Kept(message.Names), Kept(message.Positions), Kept(message.Velocities), Kept(message.Accelerations), message.FrameId);
    }

    /// <summary>Creates a message with some of the transforms.</summary>
    public static TransformsMessage Part(TransformsMessage message, Predicate<int> isIn)
    {
        var part = new TransformsMessage();
        for (var i = 0; i < message.Count; i++)
            if (isIn(i)) part.Add(message[i]);
        return part;
    }

    /// <summary>Creates a message with some of the signals.</summary>
    public static SignalsMessage Part(SignalsMessage message, Predicate<int> isIn)
    {
        var part = new SignalsMessage(message.Stamp);
        for (var i = 0; i < message.Count; i++)
            if (isIn(i)) part.Add(message[i]);
        return part;
    }

    /// <summary>Returns the message itself if all its parts are accepted; otherwise a message with the accepted parts, which may be empty.</summary>
    /// <param name="count">Number of transforms or signals in the message.</param>
    /// <param name="isAccepted">Called once for each index, in ascending order.</param>
    /// <param name="part">Creates a message with the transforms or signals at some indices.</param>
    public static T Accepted<T>(T message, int count, Predicate<int> isAccepted, Func<T, Predicate<int>, T> part)
    {
        HashSet<int> refused = null;
        for (var i = 0; i < count; i++)
            if (!isAccepted(i)) (refused ??= []).Add(i);
        return refused == null ? message : part(message, index => !refused.Contains(index));
    }

    static IEnumerable<T> Divided<T>(T message, int count, Func<int, int> sizeOf, Func<T, Predicate<int>, T> part)
    {
        var (start, bytes) = (0, EnvelopeBytes);
        for (var i = 0; i < count; i++)
        {
            var size = sizeOf(i);
            if (bytes + size > ProtocolLimits.MessageBytes)
            {
                var (from, to) = (start, i);
                yield return part(message, index => index >= from && index < to);
                (start, bytes) = (i, EnvelopeBytes);
            }

            bytes += size;
        }

        if (count > 0) yield return start == 0 ? message : part(message, index => index >= start);
    }
}
