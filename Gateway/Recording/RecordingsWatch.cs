using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Recording;

/// <summary>Detects recordings that a user has deleted, including the file that is being written.</summary>
sealed class RecordingsWatch : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    readonly Recorder _recorder;
    readonly RecordingsFolder _folder;
    readonly EventList _events;
    readonly PeriodicTask _look;
    HashSet<string> _listed = [];
    bool _isUnreadable;

    public RecordingsWatch(Recorder recorder, RecordingsFolder folder, EventList events, Action<string> log)
    {
        (_recorder, _folder, _events) = (recorder, folder, events);
        _look = new PeriodicTask(LookNow, Interval, RecorderMessages.FolderNotChecked, log, TimeProvider.System);
        _look.RunUnlessBusy();
        if (recorder.CanRecord) _look.Start();
    }

    public void Look() => _look.Exclude(LookNow);

    public void Dispose() => _look.Dispose();

    // Skips the check while the previous one is still waiting for the disk, so that at most one thread waits.
    internal void LookUnlessBusy() => _look.RunUnlessBusy();

    void LookNow()
    {
        _recorder.NoticeDeletion();
        if (Present() is not { } present) return;
        var stopped = _recorder.Status is { Problem: not null } status ? status.File : null;
        // Checks the file itself, because an old file also disappears from the list when newer files fill the list.
        foreach (var name in _listed.Where(name => !present.Contains(name) && name != stopped && _folder.Find(name) == null))
            _events.Note(new Condition("recording", name, "was deleted", "", Level.Warning));
        _listed = present;
    }

    // Returns null while the folder cannot be read. Only the first failure throws, so that it is logged once.
    HashSet<string> Present()
    {
        try
        {
            HashSet<string> present = [.. _folder.List().Select(file => file.Name)];
            _isUnreadable = false;
            return present;
        }
        catch (IOException) when (_isUnreadable)
        {
            return null;
        }
        catch (IOException)
        {
            _isUnreadable = true;
            throw;
        }
    }
}
