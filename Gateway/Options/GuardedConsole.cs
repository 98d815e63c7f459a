using System.Text;
using Microsoft.Win32.SafeHandles;

namespace Nowpose.Gateway.Options;

/// <summary>
/// The standard streams of a program. A line on stderr that cannot be written, for example because the disk is full, is lost, and the program
/// continues. A result that cannot be written to stdout is an error that names the stream. If the reader of a pipe has ended, the program ends, too.
/// </summary>
public static class GuardedConsole
{
    /// <summary>The error number EPIPE.</summary>
    const int PipeError = 32;

    /// <summary>Replaces the writers of the console. Call this method once, at the start of the program.</summary>
    public static void Set()
    {
        Console.SetError(new Writer(WriterOf(() => Console.Error), _ => { }));
        Console.SetOut(new Writer(WriterOf(Output), cause => throw new IOException(PathMessages.OutputNotWritten(cause), cause)));
    }

    /// <summary>Whether a result could not be written because the reader of the pipe has ended, as <c>head</c> does.</summary>
    public static bool IsClosedPipe(Exception e) => !OperatingSystem.IsWindows() && e is IOException { InnerException.HResult: PipeError };

    // The console ignores this error, so that the program would continue.
    static TextWriter Output()
    {
        if (OperatingSystem.IsWindows() || !Console.IsOutputRedirected) return Console.Out;
        using var file = new FileStream(new SafeFileHandle(PipeOutput.Descriptor, ownsHandle: false), FileAccess.Write, bufferSize: 0);
        return file.CanSeek ? Console.Out : new StreamWriter(new PipeOutput(), Console.OutputEncoding) { AutoFlush = true };
    }

    // The console does not open a closed stream.
    static TextWriter WriterOf(Func<TextWriter> stream)
    {
        try
        {
            return stream();
        }
        catch (Exception closed) when (IsFailure(closed))
        {
            return new ClosedWriter(closed);
        }
    }

    static bool IsFailure(Exception e) => e is IOException or UnauthorizedAccessException;

    sealed class Writer(TextWriter stream, Action<Exception> failed) : TextWriter
    {
        public override Encoding Encoding => stream.Encoding;

        public override void Write(char value) => Try(() => stream.Write(value));

        public override void Write(char[] buffer, int index, int count) => Try(() => stream.Write(buffer, index, count));

        public override void Write(string value) => Try(() => stream.Write(value));

        // In one call, so that lines of several processes do not mix.
        public override void WriteLine(string value) => Try(() => stream.WriteLine(value));

        public override void Flush() => Try(stream.Flush);

        void Try(Action write)
        {
            try
            {
                write();
            }
            catch (Exception cause) when (IsFailure(cause))
            {
                failed(cause);
            }
        }
    }

    sealed class ClosedWriter(Exception cause) : TextWriter
    {
        public override Encoding Encoding => Encoding.UTF8;

        public override void Write(char value) => throw cause;
    }
}
