namespace Nowpose.Gateway.MotionRecordings;

/// <summary>Passes on the bytes of a text, and reports a line that is too long before all of it is read.</summary>
/// <param name="tooLong">Called with the number of the line; must throw.</param>
/// <param name="max">Maximum length of a line in bytes.</param>
sealed class LineLimitStream(Stream text, Action<int> tooLong, int max) : Stream
{
    long _length;
    int _line = 1;

    public override bool CanRead => true;
    public override bool CanSeek => false;
    public override bool CanWrite => false;
    public override long Length => throw new NotSupportedException();
    public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }

    public override int Read(Span<byte> buffer)
    {
        var read = text.Read(buffer);
        for (var rest = buffer[..read]; rest.Length > 0;)
        {
            var end = rest.IndexOf((byte)'\n');
            _length += end < 0 ? rest.Length : end;
            if (_length > max) tooLong(_line);
            if (end < 0) break;
            (_length, _line) = (0, _line + 1);
            rest = rest[(end + 1)..];
        }

        return read;
    }

    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

    public override void Flush() => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        if (disposing) text.Dispose();
        base.Dispose(disposing);
    }
}
