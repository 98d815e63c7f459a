namespace Nowpose.Gateway.MotionRecordings;

/// <summary>Joint positions over time from a user's file, with linear interpolation between rows.</summary>
/// <remarks>
/// Units are as in the file (rad, m). Times are seconds relative to the first row, because a double cannot hold seconds since 1970
/// precisely. Immutable and thread-safe.
/// </remarks>
public sealed class MotionRecording
{
    readonly string[] _names;
    readonly double[] _times;
    readonly double[] _positions;

    internal MotionRecording(string[] names, double start, double[] times, double[] positions) =>
        (_names, Start, _times, _positions) = (names, start, times, positions);

    /// <summary>The joints, in the order of the file's columns and of <see cref="At"/>.</summary>
    public IReadOnlyList<string> Names => _names;

    /// <summary>Whether the columns are the position (m) and the unit quaternion of a rigid body instead of joints.</summary>
    public bool IsBody { get; internal init; }

    /// <summary>Path of the file, for messages; empty if the motion was not read from a file.</summary>
    public string Source { get; internal init; } = "";

    /// <summary>Time of the first row as given in the file, s.</summary>
    public double Start { get; }

    /// <summary>Time of the last row relative to the first, s; positive.</summary>
    public double Duration => _times[^1];

    /// <summary>
    /// Reads <c>FILE.csv</c> or <c>FILE.csv.gz</c>. The file has a header; the first column is the time <c>t</c> or <c>t_s</c> (seconds,
    /// strictly increasing), and each further column is a joint.
    /// </summary>
    /// <exception cref="InputException">The file cannot be read or has another format. The message names file, line and field.</exception>
    public static MotionRecording Read(string path)
    {
        if (RecordingText.IsSession(path)) throw new InputException(MotionFileMessages.Session(path));
        return RecordingText.Read(path, text =>
        {
            using var reader = new MotionRecordingReader(path, text);
            return reader.Read();
        });
    }

    /// <summary>Gets the positions of all joints at a given time. Times outside the recording give the first or the last row.</summary>
    /// <param name="secondsSinceStart">Time relative to <see cref="Start"/>, s.</param>
    /// <param name="positions">Receives one element per joint, in the order of <see cref="Names"/>.</param>
    public void At(double secondsSinceStart, Span<double> positions)
    {
        var after = FirstRowAfter(secondsSinceStart);
        if (after == 0 || after == _times.Length)
        {
            Row(after == 0 ? 0 : after - 1).CopyTo(positions);
            return;
        }
        var before = _times[after - 1];
        Blend(Row(after - 1), Row(after), (secondsSinceStart - before) / (_times[after] - before), positions);
    }

    /// <summary>Times of the rows relative to <see cref="Start"/>, s.</summary>
    public IReadOnlyList<double> Times => _times;

    /// <summary>Gets the recorded positions of a joint, one per row.</summary>
    /// <param name="joint">Index into <see cref="Names"/>.</param>
    public double[] PositionsOf(int joint) => [.. Enumerable.Range(0, _times.Length).Select(row => _positions[row * _names.Length + joint])];

    /// <summary>Whether a position in a row differs from that in the row before it.</summary>
    /// <param name="row">Index of the row, 1 or more.</param>
    internal bool ChangesAt(int row) => !Row(row).SequenceEqual(Row(row - 1));

    int FirstRowAfter(double seconds)
    {
        var found = Array.BinarySearch(_times, seconds);
        return found < 0 ? ~found : found + 1;
    }

    ReadOnlySpan<double> Row(int index) => _positions.AsSpan(index * _names.Length, _names.Length);

    static void Blend(ReadOnlySpan<double> from, ReadOnlySpan<double> to, double share, Span<double> result)
    {
        for (var i = 0; i < result.Length; i++) result[i] = from[i] + (to[i] - from[i]) * share;
    }
}
