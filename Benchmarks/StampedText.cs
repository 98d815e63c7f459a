using System.Buffers.Text;
using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks;

/// <summary>The bytes of a JSON message of seven joints. Its time stamp is changed in place, so that the message is formatted only once.</summary>
sealed class StampedText
{
    // Maximum lengths of the two parts of a time stamp. Shorter ones are padded with spaces, which JSON allows.
    const int SecondsLength = 10, NanosecondsLength = 9;
    static readonly ControlTime Longest = ControlTime.FromSeconds(4_000_000_000) + TimeSpan.FromMilliseconds(500);

    readonly int _seconds;
    readonly int _nanoseconds;

    public StampedText(double[] positions)
    {
        var text = RosbridgeWriter.Publish(
            RosTopics.JointStates, new JointStateMessage(Longest, SevenJointArm.JointNames, positions), RosTimeForm.Sec);
        Utf8 = Encoding.UTF8.GetBytes(text);
        _seconds = text.IndexOf("4000000000", StringComparison.Ordinal);
        _nanoseconds = text.IndexOf("500000000", StringComparison.Ordinal);
    }

    public byte[] Utf8 { get; }

    public void Stamp(ControlTime stamp)
    {
        Write(stamp.Nanoseconds / 1_000_000_000, Utf8.AsSpan(_seconds, SecondsLength));
        Write(stamp.Nanoseconds % 1_000_000_000, Utf8.AsSpan(_nanoseconds, NanosecondsLength));
    }

    static void Write(long number, Span<byte> into)
    {
        into.Fill((byte)' ');
        Utf8Formatter.TryFormat(number, into, out _);
    }
}
