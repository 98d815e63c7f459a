using System.Diagnostics;
using System.Text;
using System.Text.Json;
using Nowpose.Web;

namespace Nowpose.Vision;

/// <summary>A Node.js process that analyses one picture after another. Not thread-safe.</summary>
sealed class VisionWorker : IDisposable
{
    const int ErrorsKept = 4000;

    static readonly string Script = Path.Combine(AppContext.BaseDirectory, "vision", "worker.mjs");

    readonly string _script;
    readonly Process _process;
    readonly StringBuilder _errors = new();
    bool _isAnswered;

    /// <param name="script">Script to run; null for the script of this program.</param>
    /// <exception cref="InputException">Node.js is not installed, or was not installed when this program was built.</exception>
    public VisionWorker(string script = null)
    {
        _script = script ?? Script;
        _process = NodeProgram.Start(
            PictureReaderMessages.NodeNeeded, _script, [], process => process.ErrorDataReceived += (_, line) => Keep(line.Data));
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

    /// <summary>Whether the process is running and has responded to each request.</summary>
    public bool IsIdle => _isAnswered && !_process.HasExited;

    /// <param name="request">Request as one line of JSON.</param>
    /// <exception cref="WorkerEndedException">The worker process has exited.</exception>
    public JsonElement Ask(string request)
    {
        _isAnswered = false;
        try
        {
            _process.StandardInput.Write(request + "\n");
            _process.StandardInput.Flush();
            if (_process.StandardOutput.ReadLine() is string answer)
            {
                var parsed = JsonDocument.Parse(answer).RootElement;
                _isAnswered = true;
                return parsed;
            }
        }
        catch (IOException)
        {
            // The pipe is closed. The error is reported below.
        }
        // WaitForExit with a timeout can return before the last error lines have been read; WaitForExit without one waits for them.
        if (_process.WaitForExit(1000)) _process.WaitForExit();
        lock (_errors) throw new WorkerEndedException(PictureReaderMessages.Ended(_script, _errors.ToString().Trim()));
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
