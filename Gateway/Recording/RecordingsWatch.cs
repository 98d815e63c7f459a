using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Recording;

/// <summary>Notices recordings that are deleted, also the one that is being written.</summary>
sealed class RecordingsWatch : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    readonly Recorder _recorder;
    readonly RecordingsFolder _folder;
    readonly EventList _events;
    readonly Action<string> _log;
    readonly Lock _lock = new();
    readonly Timer _timer;
    HashSet<string> _listed;

    public RecordingsWatch(Recorder recorder, RecordingsFolder folder, EventList events, Action<string> log)
    {
        (_recorder, _folder, _events, _log) = (recorder, folder, events, log);
        _listed = [.. folder.List().Select(file => file.Name)];
        _timer = new Timer(_ => LookUnlessBusy());
        if (recorder.CanRecord) _timer.Change(Interval, Interval);
    }

    public void Look()
    {
        lock (_lock)
        {
            _recorder.NoticeDeletion();
            var present = _folder.List().Select(file => file.Name).ToHashSet();
            var stopped = _recorder.Status is { Problem: not null } status ? status.File : null;
            // Beyond the longest list a file that is missing may only have become too old for it.
            foreach (var name in _listed.Where(name => !present.Contains(name) && name != stopped && _folder.Find(name) == null))
                _events.Note(new Condition("recording", name, "was deleted", "", Level.Warning));
            _listed = present;
        }
    }

    public void Dispose() => _timer.Dispose();

    // On a disk that hangs, one thread waits and not one more each second.
    internal void LookUnlessBusy()
    {
        if (!_lock.TryEnter()) return;
        try
        {
            Look();
        }
        catch (Exception e)
        {
            // All of them: an exception that leaves a timer's thread ends the process.
            _log($"recordings: the folder could not be checked ({e.GetType().Name}: {e.Message})");
        }
        finally
        {
            _lock.Exit();
        }
    }
}
