using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Configuration;

/// <summary>The result of a check: lines "key value" for valid settings, and all errors.</summary>
/// <param name="wrong">The errors that were found before the check.</param>
sealed class Findings(IEnumerable<string> wrong)
{
    readonly List<string> _good = [];
    readonly List<string> _wrong = [.. wrong];

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

    /// <summary>Writes the valid settings to the standard output.</summary>
    /// <exception cref="InputException">There are errors. The message lists all of them.</exception>
    public void Conclude()
    {
        foreach (var line in _good) Console.Out.WriteLine(line);
        if (_wrong.Count > 0) throw new WrongEntriesException([.. _wrong.Distinct()]);
        Console.Out.WriteLine("state checked");
    }
}
