using Nowpose.Gateway.Messages;
using Nowpose.Recording;

namespace Nowpose.Gateway.Recording;

/// <summary>One session file while it is written. Producers put records into a ring buffer; a separate thread writes them.</summary>
sealed class RecordedFile
{
    /// <summary>Capacity for eight seconds of a thousand messages each; a power of two.</summary>
    const int RingLength = 8192;

    const double MaxMegabytes = 500;

    /// <summary>Size at which the next file is started, before this one is full, so that nothing is lost between them.</summary>
    internal const long MaxBytes = (long)(0.9 * MaxMegabytes * 1e6);

    readonly RecordRing _ring = new(RingLength, DropsLine.Count);
    readonly RecordWriter _writer;
    LineFile _lines;
    long _offered;
    int _isNextAskedFor;
    volatile string _deletion;

    /// <param name="open">Creates the file at this path; called on the writing thread.</param>
    public RecordedFile(string path, Func<string, LineFile> open, string cell, DescribedRobot robot, DateTime startedUtc)
    {
        Path = path;
        Robot = robot;
        var line = new JsonLine();
        HeaderLine.WriteOfGateway(line, cell, robot.Model, startedUtc);
        var settings = new RecordingSettings(path, () => _lines = open(path), MaxMegabytes);
        _writer = new RecordWriter(settings, _ring, line, new RecordLine(line, 0, new StatisticsLine()));
        _writer.Start();
    }

    public string Path { get; }

    /// <summary>The robot in the file's header.</summary>
    public DescribedRobot Robot { get; }

    /// <summary>Time at which the next file replaced this one, a count of <see cref="System.Diagnostics.Stopwatch"/>.</summary>
    public long RetiredAt { get; set; }

    /// <summary>Whether the file was deleted, so that its content is lost.</summary>
    public bool IsDeleted { get; private set; }

    /// <inheritdoc cref="RecordingStatus.IsDeletedWhileWritten"/>
    public bool IsDeletedWhileWritten => _deletion != null;

    public RecordingState State => _writer.State;

    /// <summary>The reason why the recording ended because of an error; null otherwise.</summary>
    public string Problem => _deletion ?? _writer.Problem;
    public long Bytes => _writer.Written;
    public Task Ended => _writer.Ended;

    /// <summary>Number of records in the file or on their way to it. Thread-safe.</summary>
    public long Records => State == RecordingState.Recording && !IsDeleted ? Interlocked.Read(ref _offered) - _ring.Lost : Written;

    /// <summary>Number of missing records: because the ring was full, or since the disk failed. Thread-safe.</summary>
    public long Lost => Interlocked.Read(ref _offered) - Records;

    /// <summary>Whether the file has reached its maximum size and the next one must be started. True only once. Thread-safe.</summary>
    public bool AsksForTheNext(long maxBytes) => Bytes > maxBytes && Interlocked.Exchange(ref _isNextAskedFor, 1) == 0;

    /// <summary>
    /// Gets a record to fill and pass to <see cref="Publish"/>; null if it cannot be stored, which is counted as lost. Thread-safe; does not wait.
    /// </summary>
    public SessionRecord TryClaim(RecordKind kind)
    {
        Interlocked.Increment(ref _offered);
        return State == RecordingState.Recording && !IsDeleted ? _ring.TryClaim(kind) : null;
    }

    public void Publish(SessionRecord record) => _ring.Publish(record);

    /// <summary>Stops the recording. Records up to now are still written. Returns immediately; see <see cref="Ended"/>.</summary>
    public void Stop() => _writer.Stop();

    /// <summary>Reports that the file was removed from the folder.</summary>
    /// <param name="isRecording">Whether it was still being written. This is an error, and the file is ended.</param>
    public void SetDeleted(bool isRecording)
    {
        IsDeleted = true;
        if (isRecording) _deletion = RecorderMessages.Deleted;
    }

    /// <summary>Whether the file has been created.</summary>
    public bool IsMade => _lines != null;

    long Written => IsDeleted ? 0 : _lines?.Records ?? 0;
}
