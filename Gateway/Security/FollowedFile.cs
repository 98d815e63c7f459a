namespace Nowpose.Gateway.Security;

/// <summary>What a file says: read again, when it is asked for, after the file changed. Any thread.</summary>
sealed class FollowedFile<T>
{
    /// <param name="fault">Why not all of the file can be used; null where it can.</param>
    /// <exception cref="InputException">Nothing of it can be used.</exception>
    public delegate T Reader(out string fault);

    readonly FileInfo[] _files;
    readonly Reader _read;
    readonly TimeSpan _settles;
    readonly Action<string> _log;
    readonly object _gate = new();
    T _value;
    Stamp[] _stamps;
    string _fault;

    /// <param name="paths">Of the file, or of all that are read together.</param>
    /// <param name="settles">A file that was written less than this ago is looked at later: somebody may still be at it.</param>
    /// <param name="log">Is told once of each fault; null for nobody.</param>
    /// <exception cref="InputException">The file cannot be used now.</exception>
    public FollowedFile(IEnumerable<string> paths, Reader read, TimeSpan settles, Action<string> log)
    {
        _files = [.. paths.Where(path => path != null).Select(path => new FileInfo(path))];
        _read = read;
        _settles = settles;
        _log = log ?? (_ => { });
        // Before it is read: what is written meanwhile is then seen as a change.
        _stamps = Stamps();
        _value = read(out var fault);
        if (fault != null) throw new InputException(fault);
    }

    public T Current
    {
        get
        {
            lock (_gate)
            {
                var stamps = Stamps();
                if (!stamps.AsSpan().SequenceEqual(_stamps) && stamps.All(stamp => stamp.IsOlderThan(_settles))) ReadAgain(stamps);
                return _value;
            }
        }
    }

    void ReadAgain(Stamp[] stamps)
    {
        try
        {
            _value = _read(out var fault);
            _stamps = stamps;
            Tell(fault, "; what else it says holds");
        }
        catch (InputException fault)
        {
            // Looked at again the next time: it may have been locked only.
            Tell(fault.Message, "; what it said before goes on, also what was removed from it");
        }
    }

    void Tell(string fault, string consequence)
    {
        if (fault != null && fault != _fault) _log(fault + consequence);
        _fault = fault;
    }

    Stamp[] Stamps() => [.. _files.Select(Stamp.Of)];

    readonly record struct Stamp(DateTime Written, long Length)
    {
        // Of a file that is not there the same each time.
        public static Stamp Of(FileInfo file)
        {
            file.Refresh();
            return new Stamp(file.LastWriteTimeUtc, file.Exists ? file.Length : -1);
        }

        // Of a file from the future too: clocks of file servers differ.
        public bool IsOlderThan(TimeSpan age) => (DateTime.UtcNow - Written).Duration() >= age;
    }
}
