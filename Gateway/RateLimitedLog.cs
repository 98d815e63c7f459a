namespace Nowpose.Gateway;

/// <summary>
/// Writes log lines, at most <see cref="LinesAMinute"/> equal ones per minute, so that clients cannot fill the disk. Lines with a kind have a limit of
/// their own, so that clients cannot suppress them with other lines. At the end of the minute, writes the number of suppressed lines. Thread-safe.
/// </summary>
sealed class RateLimitedLog : IDisposable
{
    public const int LinesAMinute = 10;

    /// <summary>Maximum number of lines of one kind per minute.</summary>
    public const int LinesOfAKindAMinute = 100;

    /// <summary>Maximum number of different lines that are counted separately. All further lines are counted together.</summary>
    public const int MaxKinds = 100;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Action<string> _log;
    readonly TimeProvider _time;
    readonly Dictionary<string, (long Since, int Count, int Max)> _lines = [];
    ITimer _timer;

    public RateLimitedLog(Action<string> log, TimeProvider time) => (_log, _time) = (log, time);

    public void Write(string line) => Write(line, null, LinesAMinute);

    /// <param name="kind">Kind of the line, without text from clients.</param>
    public void Write(string line, string kind) => Write(line, kind, LinesOfAKindAMinute);

    public void Dispose()
    {
        _timer?.Dispose();
        Conclude(TimeSpan.Zero);
    }

    void Conclude(TimeSpan age)
    {
        KeyValuePair<string, (long Since, int Count, int Max)>[] over;
        lock (_lines)
        {
            over = [.. _lines.Where(line => _time.GetElapsedTime(line.Value.Since) >= age)];
            foreach (var (line, _) in over) _lines.Remove(line);
        }

        foreach (var (line, seen) in over)
            if (seen.Count > seen.Max) _log(LimitMessages.MoreLines(line, seen.Count - seen.Max));
    }

    void Write(string line, string kind, int max)
    {
        Conclude(Span);
        lock (_lines)
        {
            _timer ??= _time.CreateTimer(_ => Conclude(Span), null, Span, Span);
            kind ??= _lines.ContainsKey(line) || _lines.Count < MaxKinds ? line : "other lines";
            var (since, count, _) = _lines.GetValueOrDefault(kind, (_time.GetTimestamp(), 0, max));
            _lines[kind] = (since, count + 1, max);
            if (count >= max) return;
        }

        _log(line);
    }
}
