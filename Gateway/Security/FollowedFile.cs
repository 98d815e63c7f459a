using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Security;

/// <summary>The content of a file. It is read again on access after the file has changed. Thread-safe.</summary>
sealed class FollowedFile<T>
{
    /// <param name="fault">The reason why a part of the file is invalid; null if all of it is valid.</param>
    /// <exception cref="InputException">The whole file is invalid.</exception>
    public delegate T Reader(out string fault);

    readonly FileInfo[] _files;
    readonly Reader _read;
    readonly TimeSpan _settles;
    readonly Action<string> _log;
    readonly object _gate = new();
    T _value;
    Stamp[] _stamps;
    string _fault;

    /// <param name="paths">Path of the file, or of all files that are read together.</param>
    /// <param name="settles">Minimum age of a change before the file is read again, because it may still be being written.</param>
    /// <param name="log">Receives one line per fault; null for none.</param>
    /// <exception cref="InputException">The file is invalid.</exception>
    public FollowedFile(IEnumerable<string> paths, Reader read, TimeSpan settles, Action<string> log)
    {
        _files = [.. paths.Where(path => path != null).Select(path => new FileInfo(path))];
        _read = read;
        _settles = settles;
        _log = log ?? (_ => { });
        // Taken before reading, so that a change during the reading is detected later.
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
            var value = _read(out var fault);
            if (IsChangedSince(stamps)) return;
            _value = value;
            _stamps = stamps;
            Tell(fault, AccessMessages.OtherLinesUsed);
        }
        catch (InputException fault)
        {
            if (IsChangedSince(stamps)) return;
            // Read again on the next access, because it may only have been locked.
            Tell(fault.Message, AccessMessages.FormerContentUsed);
        }
    }

    // A file that changed while it was read may have been read empty or in part. It is read again when it has settled.
    bool IsChangedSince(Stamp[] stamps) => !Stamps().AsSpan().SequenceEqual(stamps);

    void Tell(string fault, string consequence)
    {
        if (fault != null && fault != _fault) _log(fault + consequence);
        _fault = fault;
    }

    Stamp[] Stamps() => [.. _files.Select(Stamp.Of)];

    readonly record struct Stamp(DateTime Written, long Length)
    {
        // Constant for a missing file.
        public static Stamp Of(FileInfo file)
        {
            file.Refresh();
            return new Stamp(file.LastWriteTimeUtc, file.Exists ? file.Length : -1);
        }

        // Handles times in the future, too: clocks of file servers differ.
        public bool IsOlderThan(TimeSpan age) => (DateTime.UtcNow - Written).Duration() >= age;
    }
}
