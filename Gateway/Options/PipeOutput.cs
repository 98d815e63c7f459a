using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Options;

/// <summary>
/// Writes to a standard output that is a pipe, on Linux and macOS. If another program has made the pipe non-blocking, waits for its reader. An error
/// is an exception whose HResult is the error number, also if the reader has ended.
/// </summary>
sealed class PipeOutput : Stream
{
    /// <summary>The file descriptor of the standard output.</summary>
    internal const int Descriptor = 1;

    const int Interrupted = 4;
    const short Writable = 4;

    static readonly int WouldBlock = OperatingSystem.IsMacOS() ? 35 : 11;

    public override bool CanRead => false;
    public override bool CanSeek => false;
    public override bool CanWrite => true;
    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        while (!buffer.IsEmpty)
        {
            var written = Write(Descriptor, ref MemoryMarshal.GetReference(buffer), buffer.Length);
            if (written >= 0) buffer = buffer[(int)written..];
            else AwaitReader(Marshal.GetLastPInvokeError());
        }
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override void Flush()
    {
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();
    public override void SetLength(long value) => throw new NotSupportedException();

    static void AwaitReader(int error)
    {
        if (error == Interrupted) return;
        if (error != WouldBlock) throw new IOException(Marshal.GetPInvokeErrorMessage(error), error);
        var output = new Polled { Descriptor = Descriptor, Events = Writable };
        _ = Poll(ref output, 1, Timeout.Infinite);
    }

    [DllImport("libc", EntryPoint = "write", SetLastError = true)]
    static extern nint Write(int descriptor, ref byte buffer, nint count);

    [DllImport("libc", EntryPoint = "poll")]
    static extern int Poll(ref Polled output, nuint count, int timeoutMs);

    struct Polled
    {
        public int Descriptor;
        public short Events;
        public short Returned;
    }
}
