using System.Text;

namespace Nowpose.Tests.Common;

/// <summary>One run of a program within this process, with its exit status and what it printed. Runs may go side by side.</summary>
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
        // Threads of a run write side by side.
        Captured.Value = (TextWriter.Synchronized(output), TextWriter.Synchronized(errors));
        var status = await run();
        return (status, output.ToString(), errors.ToString());
    }

    public static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);

    /// <summary>Writes for the run it is called from; outside of all, to the console.</summary>
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
