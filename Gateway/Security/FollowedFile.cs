namespace Nowpose.Gateway.Security;

/// <summary>The content of a file. After a change of the file, the next access reads it again. Thread-safe.</summary>
sealed class FollowedFile<T>
{
    /// <summary>Reads the file.</summary>
    /// <param name="fault">Message about an invalid part of the file; null if the file is valid.</param>
    /// <exception cref="InputException">The file cannot be read, or is invalid as a whole.</exception>
    public delegate T Reader(out string fault);

    readonly FileInfo[] _files;
    readonly Reader _read;
    readonly TimeSpan _settles;
    readonly Action<string> _log;
    readonly Action<T, T> _replaced;
    readonly object _gate = new();
    T _value;
    Stamp[] _stamps;
    // Fault of a part of the content that is used, and the present fault. Both are null if there is none.
    string _faultOfValue;
    volatile string _fault;

    /// <param name="paths">Path of the file, or paths of all files that are read together.</param>
    /// <param name="read">Reads the file.</param>
    /// <param name="settles">Minimum age of a change before the file is read again, so that a program can finish writing it.</param>
    /// <param name="log">Receives one line per fault; null for no log.</param>
    /// <param name="replaced">Called with the former and the new content when a new content is used; null for no call.</param>
    /// <exception cref="InputException">The file is invalid.</exception>
    public FollowedFile(IEnumerable<string> paths, Reader read, TimeSpan settles, Action<string> log, Action<T, T> replaced = null)
    {
        _files = [.. paths.Where(path => path != null).Select(path => new FileInfo(path))];
        _read = read;
        _settles = settles;
        _log = log ?? (_ => { });
        _replaced = replaced;
        // Gets the stamps before reading, so that a change during the reading is detected later.
        _stamps = Stamps();
        _value = read(out var fault);
        if (fault != null) throw new InputException(fault);
    }

    /// <summary>
    /// The fault of the file when it was last accessed, and its consequence: other parts or the previous content are used. Null if there is none.
    /// </summary>
    public string Fault => _fault;

    public T Current
    {
        get
        {
            lock (_gate)
            {
                var stamps = Stamps();
                if (stamps.AsSpan().SequenceEqual(_stamps)) _fault = _faultOfValue;
                else if (stamps.All(stamp => stamp.IsOlderThan(_settles))) ReadAgain(stamps);
                return _value;
            }
        }
    }

    void ReadAgain(Stamp[] stamps)
    {
        try
        {
            var value = _read(out var fault);
            if (IsChangedSince(stamps)) return;
            _replaced?.Invoke(_value, value);
            _value = value;
            _stamps = stamps;
            _faultOfValue = fault == null ? null : fault + AccessMessages.OtherLinesUsed;
            SetFault(_faultOfValue);
        }
        catch (Exception fault) when (fault is InputException or IOException)
        {
            if (IsChangedSince(stamps)) return;
            // Keeps the old stamps, so that the next access tries again: the file may only have been locked.
            SetFault(fault.Message + AccessMessages.FormerContentUsed);
        }
    }

    // Whether a file changed while it was read. Its content may then be incomplete, and a later access reads it again.
    bool IsChangedSince(Stamp[] stamps) => !Stamps().AsSpan().SequenceEqual(stamps);

    void SetFault(string fault)
    {
        if (fault != null && fault != _fault) _log(fault);
        _fault = fault;
    }

    Stamp[] Stamps() => [.. _files.Select(Stamp.Of)];

    readonly record struct Stamp(DateTime Written, long Length)
    {
        // Returns a constant stamp for a missing file.
        public static Stamp Of(FileInfo file)
        {
            file.Refresh();
            return new Stamp(file.LastWriteTimeUtc, file.Exists ? file.Length : -1);
        }

        // Uses the magnitude, because the clock of a file server may be ahead of this machine's.
        public bool IsOlderThan(TimeSpan age) => (DateTime.UtcNow - Written).Duration() >= age;
    }
}
