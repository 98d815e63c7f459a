namespace Nowpose.Gateway.Recording;

/// <summary>A buffered file of lines that counts the lines on the disk exactly, even if the disk becomes full within a line.</summary>
/// <remarks>
/// When a write of a FileStream fails, it is unknown which part of its buffer reached the disk. Not thread-safe, except for the counts.
/// </remarks>
sealed class LineFile : Stream
{
    const int BufferBytes = 64 * 1024;

    /// <summary>Free space that a recording leaves on the disk for other programs and for the gateway's own files, bytes.</summary>
    internal const long ReservedBytes = 200_000_000;

    const byte End = (byte)'\n';

    // Beginnings of the lines that the recorder writes about the recording itself. They do not count as records.
    static readonly byte[][] Own = [.. new[] { "session", "lost", "end" }.Select(kind => System.Text.Encoding.ASCII.GetBytes($"{{\"kind\":\"{kind}\""))];

    readonly Stream _disk;
    readonly Func<long> _freeBytes;
    readonly byte[] _buffer = new byte[BufferBytes];
    int _length;
    long _lines, _waiting;
    long _keptBytes = -1;

    /// <param name="disk">The unbuffered file. It is disposed with this object.</param>
    /// <param name="freeBytes">Gets the free space of the disk; null if it is unlimited.</param>
    public LineFile(Stream disk, Func<long> freeBytes = null)
    {
        _disk = disk;
        _freeBytes = freeBytes ?? (() => long.MaxValue);
    }

    /// <summary>Creates a new file that its owner can read and write and its group can read. Fails if the file exists.</summary>
    public static LineFile Create(string path)
    {
        var options = new FileStreamOptions
        {
            Mode = FileMode.CreateNew, Access = FileAccess.Write, Share = FileShare.Read, BufferSize = 0,
        };
        if (!OperatingSystem.IsWindows())
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead;
        return new LineFile(new FileStream(path, options), () => FreeBytes(path));
    }

    // The free space is unknown, for example, for a network share on Windows.
    static long FreeBytes(string path)
    {
        try
        {
            return new DriveInfo(Path.GetFullPath(path)).AvailableFreeSpace;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return long.MaxValue;
        }
    }

    /// <summary>Whether a path exists, or may exist because it cannot be examined, for example while a network drive does not respond.</summary>
    public static bool Exists(string path)
    {
        try
        {
            File.GetAttributes(path);
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return e is not (FileNotFoundException or DirectoryNotFoundException);
        }
    }

    /// <summary>Number of records written. Includes buffered records until a write fails. Thread-safe.</summary>
    public long Records => Interlocked.Read(ref _lines) + (KeptBytes != null ? 0 : Interlocked.Read(ref _waiting));

    /// <summary>Size of the complete lines that are on the disk after a write has failed; null while none has failed. Thread-safe.</summary>
    public long? KeptBytes => Interlocked.Read(ref _keptBytes) is >= 0 and var bytes ? bytes : null;

    public override bool CanRead => false;
    public override bool CanSeek => false;
    public override bool CanWrite => true;
    public override long Length => _disk.Length;
    public override long Position { get => _disk.Position; set => throw new NotSupportedException(); }

    /// <summary>Writes one or more complete lines.</summary>
    public override void Write(ReadOnlySpan<byte> line)
    {
        if (_length + line.Length > _buffer.Length) Flush();
        Interlocked.Add(ref _waiting, RecordsIn(line));
        if (line.Length > _buffer.Length)
        {
            WriteOut(line);
            return;
        }

        line.CopyTo(_buffer.AsSpan(_length));
        _length += line.Length;
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override void Flush()
    {
        if (_length == 0) return;
        var full = _buffer.AsSpan(0, _length);
        _length = 0;
        WriteOut(full);
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();
    public override void SetLength(long value) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        try
        {
            if (disposing && KeptBytes == null) Flush();
        }
        finally
        {
            if (disposing) _disk.Dispose();
            base.Dispose(disposing);
        }
    }

    void WriteOut(ReadOnlySpan<byte> lines)
    {
        var before = _disk.Position;
        try
        {
            if (_freeBytes() < lines.Length + ReservedBytes) throw new IOException(RecorderMessages.DiskAlmostFull);
            _disk.Write(lines);
        }
        catch
        {
            var kept = TruncateToWholeLines(before, lines);
            Interlocked.Exchange(ref _keptBytes, before + kept);
            Interlocked.Add(ref _lines, RecordsIn(lines[..kept]));
            throw;
        }

        Interlocked.Add(ref _lines, RecordsIn(lines));
        Interlocked.Exchange(ref _waiting, 0);
    }

    // Truncates the file after the last complete line that reached the disk. Returns the number of bytes of `lines` that remain.
    int TruncateToWholeLines(long before, ReadOnlySpan<byte> lines)
    {
        try
        {
            var reached = (int)Math.Clamp(_disk.Length - before, 0, lines.Length);
            var whole = lines[..reached].LastIndexOf(End) + 1;
            _disk.SetLength(before + whole);
            return whole;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            return 0;
        }
    }

    static int RecordsIn(ReadOnlySpan<byte> lines)
    {
        var records = 0;
        for (var end = lines.IndexOf(End); end >= 0; end = lines.IndexOf(End))
        {
            if (!IsOwn(lines)) records++;
            lines = lines[(end + 1)..];
        }

        return records;
    }

    static bool IsOwn(ReadOnlySpan<byte> line)
    {
        foreach (var kind in Own)
            if (line.StartsWith(kind)) return true;
        return false;
    }
}
