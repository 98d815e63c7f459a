using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Configuration;

/// <summary>What a check found: lines "key value" of what is good, and all that is wrong.</summary>
sealed class Findings
{
    readonly List<string> _good = [];
    readonly List<string> _wrong = [];

    public void Good(string key, string value)
    {
        if (value != null) _good.Add($"{key} {value}");
    }

    public T Try<T>(Func<T> check)
    {
        try
        {
            return check();
        }
        catch (WrongEntriesException wrong)
        {
            _wrong.AddRange(wrong.Lines);
        }
        catch (InputException wrong)
        {
            _wrong.Add(wrong.Message);
        }

        return default;
    }

    public void Try(Action check) => Try(() =>
    {
        check();
        return true;
    });

    /// <summary>Writes what would be served.</summary>
    /// <exception cref="InputException">Something is wrong: all of it.</exception>
    public void Conclude()
    {
        foreach (var line in _good) Console.Out.WriteLine(line);
        if (_wrong.Count > 0) throw new WrongEntriesException([.. _wrong.Distinct()]);
        Console.Out.WriteLine("state checked");
    }
}
