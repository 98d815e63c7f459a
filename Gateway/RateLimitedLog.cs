using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway;

/// <summary>
/// Writes log lines, at most <see cref="LinesAMinute"/> equal ones per minute, so that clients cannot fill the disk. At the end of the minute,
/// writes the number of suppressed lines. Thread-safe.
/// </summary>
sealed class RateLimitedLog : IDisposable
{
    public const int LinesAMinute = 10;

    /// <summary>Maximum number of different lines that are counted separately. All further lines are counted together.</summary>
    public const int MaxKinds = 100;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Action<string> _log;
    readonly TimeProvider _time;
    readonly Dictionary<string, (long Since, int Count)> _lines = [];
    ITimer _timer;

    public RateLimitedLog(Action<string> log, TimeProvider time) => (_log, _time) = (log, time);

    public void Write(string line)
    {
        Conclude(Span);
        lock (_lines)
        {
            _timer ??= _time.CreateTimer(_ => Conclude(Span), null, Span, Span);
            var kind = _lines.ContainsKey(line) || _lines.Count < MaxKinds ? line : "other lines";
            var (since, count) = _lines.GetValueOrDefault(kind, (_time.GetTimestamp(), 0));
            _lines[kind] = (since, count + 1);
            if (count >= LinesAMinute) return;
        }

        _log(line);
    }

    public void Dispose()
    {
        _timer?.Dispose();
        Conclude(TimeSpan.Zero);
    }

    void Conclude(TimeSpan age)
    {
        KeyValuePair<string, (long Since, int Count)>[] over;
        lock (_lines)
        {
            over = [.. _lines.Where(line => _time.GetElapsedTime(line.Value.Since) >= age)];
            foreach (var (line, _) in over) _lines.Remove(line);
        }

        foreach (var (line, seen) in over)
            if (seen.Count > LinesAMinute) _log(LimitMessages.MoreLines(line, seen.Count - LinesAMinute));
    }
}
