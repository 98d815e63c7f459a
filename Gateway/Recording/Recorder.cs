using System.Collections.Immutable;
using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status;
using Nowpose.Recording;

namespace Nowpose.Gateway.Recording;

/// <summary>Records the gateway's traffic to session files while it is enabled. Thread-safe; does not block the hub.</summary>
/// <remarks>
/// A new file starts when the description of a robot changes, because a file's header describes the robots, and when the file reaches its maximum
/// size. A disk error ends the recording until the recorder is enabled again. The status gives the reason and the number of missing lines.
/// </remarks>
public sealed class Recorder : IAsyncDisposable
{
    static readonly string[] Topics =
        [RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.Diagnostics, RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals];
    static readonly string[] LatchedTopics = [RosTopics.TfStatic, RosTopics.Signals];
    static readonly string[] RobotTopics = [RosTopics.JointStates, RosTopics.JointTrajectory];
    static readonly TimeSpan TickInterval = TimeSpan.FromSeconds(1);

    /// <summary>Time for which producers may still use a file after the next file has replaced it.</summary>
    static readonly TimeSpan Retirement = TimeSpan.FromSeconds(0.5);

    /// <summary>Maximum time for the last records to reach the disk. Exceeded only if the disk does not respond.</summary>
    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(8);

    readonly GatewayOptions _options;
    readonly MessageHub _hub;
    readonly PlantClocks _plant;
    readonly RecordedTraffic _traffic;
    readonly Action<string> _log;
    readonly Func<string, LineFile> _open;
    readonly Func<string, bool> _exists;
    readonly long _maxBytes;
    readonly Lock _gate = new();
    readonly List<IDisposable> _subscriptions = [];
    readonly HashSet<PlantClock> _listened = [];
    // Files that the next file has replaced, but that a publisher may still be using.
    readonly List<RecordedFile> _retired = [];
    readonly List<Task> _ending = [];
    readonly RecordingPaths _paths;
    readonly ITimer _timer;
    volatile RecordedFile _file;
    volatile bool _isWanted;
    bool _isDisposed;
    // Number of the earlier files since the recorder was enabled, with their numbers of written and of missing records and their size.
    (int Files, long Lines, long Lost, long Bytes) _before;

    /// <param name="open">Creates a file at a path that does not exist yet; null to create files on the disk.</param>
    /// <param name="maxBytes">Size of a file in bytes at which the next file is started.</param>
    internal Recorder(
        GatewayOptions options, MessageHub hub, ServedClock clock, PlantClocks plant, DropCounters drops, Action<string> log,
        Func<string, LineFile> open = null, long maxBytes = RecordedFile.MaxBytes)
    {
        _maxBytes = maxBytes;
        _options = options;
        _paths = new RecordingPaths(options.Recordings, options.Cell);
        _hub = hub;
        _plant = plant;
        _traffic = new RecordedTraffic(clock, plant, drops);
        _log = log;
        _open = open ?? LineFile.Create;
        _exists = open == null ? LineFile.Exists : _ => true;
        _timer = options.Time.CreateTimer(_ => Tick(), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        hub.Links.Changed += (_, _) => RenewOnRobotChange();
        foreach (var topic in Topics) _subscriptions.Add(hub.Subscribe(topic, Take));
        foreach (var topic in RobotTopics) _subscriptions.Add(hub.SubscribeToRobots(topic, Take));
        plant.Added += Listen;
        foreach (var asked in plant.All) Listen(asked);
    }

    /// <summary>Whether a folder for recordings is configured.</summary>
    public bool CanRecord => _options.Recordings != null;

    /// <summary>Whether the recorder is enabled and its current file has had no error.</summary>
    public bool IsOn => _isWanted && _file.Problem == null;

    /// <summary>Path of the current or last file; null before the first recording.</summary>
    public string Path => _file?.Path;

    internal RecordingStatus Status
    {
        get
        {
            lock (_gate)
            {
                if (_file == null) return RecordingStatus.None with { Can = CanRecord };
                var isDeleted = _file.IsDeleted && _file.Problem == null;
                RecordedFile[] files = [.. _retired, _file];
                return new RecordingStatus(
                    CanRecord, IsOn, System.IO.Path.GetFileName(_file.Path), _before.Lines + files.Sum(file => file.Records),
                    _before.Bytes + files.Sum(file => file.Bytes), _before.Lost + files.Sum(file => file.Lost), _file.Problem, isDeleted,
                    _before.Files + files.Length)
                {
                    IsDeletedWhileWritten = _file.IsDeletedWhileWritten,
                };
            }
        }
    }

    /// <summary>Enables the recorder and starts a file, unless a file is being written.</summary>
    /// <exception cref="InputException">No folder is configured.</exception>
    public void SwitchOn()
    {
        if (!CanRecord) throw new InputException(RecorderMessages.NoFolder);
        var next = Prepare();
        lock (_gate)
        {
            if (_isDisposed || IsOn) return;
            // The counts restart for the new recording. Buffered records of files that were replaced earlier are still written.
            EndRetired(TimeSpan.Zero);
            _retired.Clear();
            _before = default;
            Begin(next);
            _isWanted = true;
            _timer.Change(TickInterval, TickInterval);
        }

        RenewOnRobotChange();
    }

    /// <summary>Disables the recorder and ends the file. Completes when the file contains all messages received up to now.</summary>
    public Task SwitchOffAsync()
    {
        lock (_gate)
        {
            if (_isWanted)
            {
                _traffic.Tick(_file);
                End(_file);
            }

            _isWanted = false;
            EndRetired(TimeSpan.Zero);
            if (!_isDisposed) _timer.Change(Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
            return Task.WhenAll(_ending);
        }
    }

    /// <summary>Ends the recording if a user has deleted its file. Accesses the disk and may block.</summary>
    internal void NoticeDeletion()
    {
        var file = _file;
        if (file is not { IsMade: true, IsDeleted: false } || _exists(file.Path)) return;
        lock (_gate)
        {
            var isRecording = IsOn && file == _file;
            file.SetDeleted(isRecording);
            if (!isRecording) return;
            End(file);
            _log(RecorderMessages.Ended(file.Path, file.Problem));
        }
    }

    /// <summary>Ends the file like <see cref="SwitchOffAsync"/>, but stops waiting if the disk does not respond.</summary>
    public async ValueTask DisposeAsync()
    {
        foreach (var subscription in _subscriptions) subscription.Dispose();
        _plant.Added -= Listen;
        lock (_gate) _isDisposed = true;
        await _timer.DisposeAsync();
        var ended = SwitchOffAsync();
        if (await Task.WhenAny(ended, Task.Delay(TimeToEnd)) != ended)
            _log(RecorderMessages.DiskTooSlow(_file.Path, TimeToEnd.TotalSeconds));
    }

    void Take(HubMessage message)
    {
        if (!_isWanted) return;
        var file = _file;
        _traffic.Add(file, message);
        if (file.RequestsNext(_maxBytes)) ThreadPool.UnsafeQueueUserWorkItem(_ => Renew(file), null);
    }

    // Called after a new robot description and after the start of a file. If both happen at once, the later call sees both changes.
    void RenewOnRobotChange()
    {
        Interlocked.MemoryBarrier();
        if (!_isWanted) return;
        var file = _file;
        // Continues on another thread, because creating a file is slow and must not block the caller.
        if (file.Robots != _hub.Links.Described) ThreadPool.UnsafeQueueUserWorkItem(_ => Renew(file), null);
    }

    void Listen(PlantClock asked)
    {
        lock (_gate)
        {
            // A new clock may have replaced one.
            _listened.IntersectWith(_plant.All);
            if (!_listened.Add(asked)) return;
        }

        asked.Judged += (in Nowpose.Sync.SyncExchange exchange, Nowpose.Sync.SyncVerdict verdict, Nowpose.Sync.SyncExchangeFault fault) =>
        {
            if (_isWanted) _traffic.Add(_file, asked, exchange, verdict, fault);
        };
    }

    void Tick()
    {
        lock (_gate)
        {
            if (!_isWanted) return;
            EndRetired(Retirement);
            _traffic.Tick(_file);
        }
    }

    void Renew(RecordedFile old)
    {
        var next = Prepare();
        lock (_gate)
        {
            // In the meantime, another thread may have started the next file or disabled the recorder, or the disk may have failed.
            if (!IsOn || _isDisposed || _file != old) return;
            Begin(next);
            old.RetiredAt = Stopwatch.GetTimestamp();
            _retired.Add(old);
        }

        RenewOnRobotChange();
    }

    // Called without the lock, because it accesses the disk, which may take long.
    (DateTime Now, string Path, ImmutableSortedDictionary<string, DescribedRobot> Robots) Prepare()
    {
        var now = _options.Time.GetUtcNow().UtcDateTime;
        return (now, _paths.Free(now), _hub.Links.Described);
    }

    void Begin((DateTime Now, string Path, ImmutableSortedDictionary<string, DescribedRobot> Robots) next)
    {
        // Chooses another path if another thread has started a file with this path in the meantime.
        if (!_paths.TryTake(next.Path)) _paths.TryTake((next = Prepare()).Path);
        _traffic.Begin();
        var file = new RecordedFile(next.Path, _open, _options.Cell, next.Robots, next.Now);
        _file = file;
        _log(RecorderMessages.Begun(file.Path));
        _traffic.Tick(file);
        // Adds the messages that the hub keeps, because they were published before this file and are not published again.
        foreach (var topic in LatchedTopics)
            foreach (var message in _hub.ReadLatched(topic, () => 0)) _traffic.Add(file, message);
        foreach (var robot in _hub.Robots.Prepend(""))
            _hub.Subscribe(RobotTopic.NameOf(robot, RosTopics.JointTrajectory), message => _traffic.Add(file, message)).Dispose();
        _ending.RemoveAll(ended => ended.IsCompleted);
        _ = file.Ended.ContinueWith(_ => Settle(file), TaskScheduler.Default);
    }

    void EndRetired(TimeSpan since)
    {
        foreach (var file in _retired)
            if (file.State == RecordingState.Recording && Stopwatch.GetElapsedTime(file.RetiredAt) >= since) End(file);
    }

    void Settle(RecordedFile file)
    {
        if (file.Problem != null && !file.IsDeleted) _log(file.Problem);
        _paths.Release(file.Path);
        lock (_gate)
        {
            if (!_retired.Remove(file)) return;
            _before = (_before.Files + 1, _before.Lines + file.Records, _before.Lost + file.Lost, _before.Bytes + file.Bytes);
        }
    }

    void End(RecordedFile file)
    {
        file.Stop();
        _ending.Add(file.Ended);
    }
}
