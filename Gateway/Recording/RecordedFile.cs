using Nowpose.Gateway.Hub;
using Nowpose.Recording;

namespace Nowpose.Gateway.Recording;

/// <summary>One session file while it is written: who is told of something puts it into a ring, a thread of its own writes.</summary>
sealed class RecordedFile
{
    /// <summary>Eight seconds of a thousand messages each; a power of two.</summary>
    const int RingLength = 8192;

    const double GreatestMegabytes = 500;

    /// <summary>The next file is begun before this one is full, so that nothing is lost between them.</summary>
    internal const long GreatestBytes = (long)(0.9 * GreatestMegabytes * 1e6);

    readonly RecordRing _ring = new(RingLength, DropsLine.Count);
    readonly RecordWriter _writer;
    LineFile _lines;
    long _offered;
    int _isNextAskedFor;
    volatile string _deletion;

    /// <param name="open">Makes the file of this path; called on the writing thread.</param>
    public RecordedFile(string path, Func<string, LineFile> open, string cell, DescribedRobot robot, DateTime startedUtc)
    {
        Path = path;
        Robot = robot;
        var line = new JsonLine();
        HeaderLine.WriteOfGateway(line, cell, robot.Model, startedUtc);
        var settings = new RecordingSettings(path, () => _lines = open(path), GreatestMegabytes);
        _writer = new RecordWriter(settings, _ring, line, new RecordLine(line, 0, new StatisticsLine()));
        _writer.Start();
    }

    public string Path { get; }

    /// <summary>What the header was written with.</summary>
    public DescribedRobot Robot { get; }

    /// <summary>When the next file took its place, a count of <see cref="System.Diagnostics.Stopwatch"/>.</summary>
    public long RetiredAt { get; set; }

    /// <summary>Whether the file was deleted: nothing of it can be read any more.</summary>
    public bool IsDeleted { get; private set; }

    /// <inheritdoc cref="RecordingStatus.IsDeletedWhileWritten"/>
    public bool IsDeletedWhileWritten => _deletion != null;

    public RecordingState State => _writer.State;

    /// <summary>Why the recording ended by itself; null otherwise.</summary>
    public string Problem => _deletion ?? _writer.Problem;
    public long Bytes => _writer.Written;
    public Task Ended => _writer.Ended;

    /// <summary>Records in the file, or on their way into it. Any thread.</summary>
    public long Records => State == RecordingState.Recording && !IsDeleted ? Interlocked.Read(ref _offered) - _ring.Lost : Written;

    /// <summary>Records that should be in the file and are not: for want of room in the ring, or since the disk failed. Any thread.</summary>
    public long Lost => Interlocked.Read(ref _offered) - Records;

    /// <summary>Whether it is as long as it may be, so that another is to be begun: said once. Any thread.</summary>
    public bool AsksForTheNext(long greatestBytes) => Bytes > greatestBytes && Interlocked.Exchange(ref _isNextAskedFor, 1) == 0;

    /// <summary>A record to fill and hand to <see cref="Publish"/>; null when it cannot be kept: it is counted then. Any thread; waits for nobody.</summary>
    public SessionRecord TryClaim(RecordKind kind)
    {
        Interlocked.Increment(ref _offered);
        return State == RecordingState.Recording && !IsDeleted ? _ring.TryClaim(kind) : null;
    }

    public void Publish(SessionRecord record) => _ring.Publish(record);

    /// <summary>Completes when all that was recorded by now is in the file, or the recording has ended.</summary>
    public Task FlushAsync() => _writer.FlushAsync();

    /// <summary>What was recorded by now is still written; returns at once, see <see cref="Ended"/>.</summary>
    public void Stop() => _writer.Stop();

    /// <summary>The file is gone from the folder.</summary>
    /// <param name="isRecording">Whether it was still to be written: that is a problem then, and the file is ended.</param>
    public void SetDeleted(bool isRecording)
    {
        IsDeleted = true;
        if (isRecording) _deletion = "the file was deleted while it was written, and its lines are lost";
    }

    /// <summary>Whether the file has been made.</summary>
    public bool IsMade => _lines != null;

    long Written => IsDeleted ? 0 : _lines?.Records ?? 0;
}
