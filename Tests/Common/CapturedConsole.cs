using System.Text;

namespace Nowpose.Tests.Common;

/// <summary>Runs a program within this process and captures its exit status and output. Runs can be concurrent.</summary>
static class CapturedConsole
{
    static readonly AsyncLocal<(TextWriter Output, TextWriter Errors)> Captured = new();

    static CapturedConsole()
    {
        Console.SetOut(new RoutedWriter(Console.Out, () => Captured.Value.Output));
        Console.SetError(new RoutedWriter(Console.Error, () => Captured.Value.Errors));
    }

    public static async Task<(int Status, string Output, string Errors)> OfAsync(Func<Task<int>> run)
    {
        using StringWriter output = new(), errors = new();
        // The threads of a run may write concurrently.
        Captured.Value = (TextWriter.Synchronized(output), TextWriter.Synchronized(errors));
        var status = await run();
        return (status, output.ToString(), errors.ToString());
    }

    public static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);

    /// <summary>Writes to the capture of the calling run; outside any run, to the console.</summary>
    sealed class RoutedWriter(TextWriter console, Func<TextWriter> captured) : TextWriter
    {
        public override Encoding Encoding => console.Encoding;

        TextWriter Writer => captured() ?? console;

        public override void Write(char value) => Writer.Write(value);

        public override void Write(char[] buffer, int index, int count) => Writer.Write(buffer, index, count);

        public override void Write(string value) => Writer.Write(value);

        public override void Flush() => Writer.Flush();
    }
}
