using System.Collections.Immutable;
using Nowpose.Recording;

namespace Nowpose.Gateway.Recording;

/// <summary>A session file that is being written. Producers put records into a ring buffer; a separate thread writes them.</summary>
sealed class RecordedFile
{
    /// <summary>Capacity of the ring buffer in records: 8 s at 1000 messages per second. A power of two.</summary>
    const int RingLength = 8192;

    const double MaxMegabytes = 500;

    /// <summary>Size at which the next file is started. It is below the maximum, so that no record is lost during the change.</summary>
    internal const long MaxBytes = (long)(0.9 * MaxMegabytes * 1e6);

    readonly RecordRing _ring = new(RingLength, DropsLine.Count);
    readonly RecordWriter _writer;
    LineFile _lines;
    long _offered;
    int _isNextRequested;
    volatile string _deletion;

    /// <param name="path">Path of the file.</param>
    /// <param name="open">Creates the file at its path; called on the writing thread.</param>
    /// <param name="cell">Name of the cell; null if it has no name.</param>
    /// <param name="robots">The robots described in the file's header, by their namespaces.</param>
    /// <param name="startedUtc">Start of the recording, UTC.</param>
    public RecordedFile(string path, Func<string, LineFile> open, string cell, ImmutableSortedDictionary<string, DescribedRobot> robots, DateTime startedUtc)
    {
        Path = path;
        Robots = robots;
        var line = new JsonLine();
        // A robot with an invalid description has no model.
        var models = robots.Select(one => (Namespace: one.Key, Robot: one.Value.Model)).Where(one => one.Robot != null).ToArray();
        HeaderLine.WriteOfGateway(
            line, cell, models.FirstOrDefault(one => one.Namespace.Length == 0).Robot, models.Where(one => one.Namespace.Length > 0), startedUtc);
        var settings = new RecordingSettings(path, () => _lines = open(path), MaxMegabytes);
        _writer = new RecordWriter(settings, _ring, line, new RecordLine(line, 0, new StatisticsLine()));
        _writer.Start();
    }

    public string Path { get; }

    /// <summary>The robots described in the file's header, by their namespaces.</summary>
    public ImmutableSortedDictionary<string, DescribedRobot> Robots { get; }

    /// <summary>Time at which the next file replaced this one, as a <see cref="System.Diagnostics.Stopwatch"/> timestamp.</summary>
    public long RetiredAt { get; set; }

    /// <summary>Whether a user has deleted the file.</summary>
    public bool IsDeleted { get; private set; }

    /// <inheritdoc cref="RecordingStatus.IsDeletedWhileWritten"/>
    public bool IsDeletedWhileWritten => _deletion != null;

    public RecordingState State => _writer.State;

    /// <summary>The error that ended the recording; null if there is none.</summary>
    public string Problem => _deletion ?? _writer.Problem;

    /// <summary>Size of the lines in the file or waiting to be written. Thread-safe.</summary>
    public long Bytes => IsDeleted ? 0 : _lines?.KeptBytes ?? _writer.Written;

    public Task Ended => _writer.Ended;

    /// <summary>Number of records in the file or waiting to be written. Thread-safe.</summary>
    public long Records => State == RecordingState.Recording && !IsDeleted ? Interlocked.Read(ref _offered) - _ring.Lost : Written;

    /// <summary>Number of records that are missing because the ring buffer was full, the disk failed or the file was deleted. Thread-safe.</summary>
    public long Lost => Interlocked.Read(ref _offered) - Records;

    /// <summary>
    /// Returns true if the file has reached its maximum size and the next file must be started. Returns true only once. Thread-safe.
    /// </summary>
    public bool RequestsNext(long maxBytes) => Bytes > maxBytes && Interlocked.Exchange(ref _isNextRequested, 1) == 0;

    /// <summary>
    /// Gets a record to fill in and pass to <see cref="Publish"/>. Returns null, and counts the record as lost, if it cannot be stored.
    /// Thread-safe; does not block.
    /// </summary>
    public SessionRecord TryClaim(RecordKind kind)
    {
        Interlocked.Increment(ref _offered);
        return State == RecordingState.Recording && !IsDeleted ? _ring.TryClaim(kind) : null;
    }

    public void Publish(SessionRecord record) => _ring.Publish(record);

    /// <summary>Stops the recording. Returns immediately; <see cref="Ended"/> completes when the records up to now are written.</summary>
    public void Stop() => _writer.Stop();

    /// <summary>Records that a user has deleted the file.</summary>
    /// <param name="isRecording">Whether the file was still being written, which is an error.</param>
    public void SetDeleted(bool isRecording)
    {
        IsDeleted = true;
        if (isRecording) _deletion = RecorderMessages.Deleted;
    }

    /// <summary>Whether the file has been created on the disk.</summary>
    public bool IsMade => _lines != null;

    long Written => IsDeleted ? 0 : _lines?.Records ?? 0;
}
