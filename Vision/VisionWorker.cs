using System.ComponentModel;
using System.Diagnostics;
using System.Text;
using System.Text.Json;

namespace Nowpose.Vision;

/// <summary>A Node.js process that analyses one picture at a time. Not thread-safe.</summary>
sealed class VisionWorker : IDisposable
{
    const string Needed = "Node.js 20 or newer is needed to read pictures";
    const int ErrorsKept = 4000;

    static readonly string Script = Path.Combine(AppContext.BaseDirectory, "vision", "worker.mjs");

    readonly string _script;
    readonly Process _process;
    readonly StringBuilder _errors = new();

    /// <param name="script">Script; null for the one included in this program.</param>
    /// <exception cref="InputException">Node.js is missing, or was missing when this program was built.</exception>
    public VisionWorker(string script = null)
    {
        _script = script ?? Script;
        if (!File.Exists(_script)) throw new InputException($"{Needed}; this program was built without it: install it and build again");
        _process = new Process
        {
            StartInfo = new ProcessStartInfo("node", [_script])
            {
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardInputEncoding = new UTF8Encoding(false),
                StandardOutputEncoding = Encoding.UTF8,
            },
        };
        _process.ErrorDataReceived += (_, line) => Keep(line.Data);
        try
        {
            _process.Start();
        }
        catch (Win32Exception e)
        {
            throw new InputException($"{Needed}; it could not be started: {e.Message}. Install it from nodejs.org", e);
        }
        _process.BeginErrorReadLine();
        try
        {
            Ask(CodePattern.Json());
        }
        catch (WorkerEndedException)
        {
            Dispose();
            throw;
        }
    }

    /// <param name="request">One line of JSON.</param>
    /// <exception cref="WorkerEndedException">The worker has ended.</exception>
    public JsonElement Ask(string request)
    {
        try
        {
            _process.StandardInput.Write(request + "\n");
            _process.StandardInput.Flush();
            if (_process.StandardOutput.ReadLine() is string answer) return JsonDocument.Parse(answer).RootElement;
        }
        catch (IOException)
        {
            // The pipe is closed; the error is reported below.
        }
        // The wait with a limit does not wait for the last error lines; the wait without one does.
        if (_process.WaitForExit(1000)) _process.WaitForExit();
        lock (_errors) throw new WorkerEndedException($"the picture reader ended unexpectedly ({_script}): {_errors.ToString().Trim()}");
    }

    public void Dispose()
    {
        try
        {
            _process.Kill();
        }
        catch (InvalidOperationException)
        {
            // The process has already ended.
        }
        _process.Dispose();
    }

    void Keep(string line)
    {
        lock (_errors)
            if (_errors.Length < ErrorsKept) _errors.AppendLine(line);
    }
}
