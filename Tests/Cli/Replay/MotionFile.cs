using System.Globalization;
using System.Text;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>An artificial recording with decimal numbers, so that a reference can compute its times exactly.</summary>
sealed class MotionFile
{
    public MotionFile(decimal start, IEnumerable<decimal> elapsed, params Func<double, double>[] joints)
    {
        Start = start;
        Times = [.. elapsed];
        Positions = [.. Times.Select(t => joints.Select(joint => joint((double)t)).ToArray())];
    }

    public decimal Start { get; }

    /// <summary>Times since the start, s.</summary>
    public decimal[] Times { get; }

    /// <summary>Positions, one row per time.</summary>
    public double[][] Positions { get; }

    public int Joints => Positions[0].Length;

    public static IEnumerable<decimal> EvenTimes(decimal duration, decimal step)
    {
        for (var t = 0m; t <= duration; t += step) yield return t;
    }

    /// <summary>Returns times with steps of 1 to 9 ms and a resolution of 1 µs. The last one equals the duration.</summary>
    public static IEnumerable<decimal> UnevenTimes(decimal duration, int seed)
    {
        var random = new Random(seed);
        for (var t = 0m; t < duration; t += random.Next(1000, 9000) / 1000000m) yield return t;
        yield return duration;
    }

    public double[] At(decimal time)
    {
        if (time >= Times[^1]) return Positions[^1];
        var after = 1;
        while (Times[after] <= time) after++;
        var share = (double)((time - Times[after - 1]) / (Times[after] - Times[after - 1]));
        return [.. Positions[after - 1].Zip(Positions[after], (a, b) => a + (b - a) * share)];
    }

    public string WriteTo(string folder)
    {
        var text = new StringBuilder("t").AppendJoin("", Enumerable.Range(1, Joints).Select(j => ",q" + j)).Append('\n');
        for (var row = 0; row < Times.Length; row++)
            text.Append((Start + Times[row]).ToString(CultureInfo.InvariantCulture))
                .AppendJoin("", Positions[row].Select(p => "," + p.ToString("R", CultureInfo.InvariantCulture))).Append('\n');
        var path = Path.Combine(folder, "motion.csv");
        File.WriteAllText(path, text.ToString());
        return path;
    }
}
