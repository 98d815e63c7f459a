using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Runtime.CompilerServices;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring.Sequences
{
    public class SimulatedSequenceTests
    {
        [TestCase("noise.txt")]
        [TestCase("stale.txt")]
        [TestCase("origin.txt")]
        [TestCase("lost-and-back.txt")]
        [TestCase("two-disagree.txt")]
        [TestCase("one-moved.txt")]
        public void LinesOf_EachSequence_EqualTheLinesOfItsStoredFile(string file)
        {
            var path = Path.Combine(Here(), file);
            // If the environment variable is set to 1, the test writes new files.
            if (Environment.GetEnvironmentVariable("NOWPOSE_WRITE_SEQUENCES") == "1") Write(path, SimulatedSequence.LinesOf(file));
            var lines = new List<string>(File.ReadAllLines(path));
            lines.RemoveAll(line => line.StartsWith('#'));

            var made = SimulatedSequence.LinesOf(file);

            Assert.That(lines, Has.Count.EqualTo(made.Count));
            for (var i = 0; i < made.Count; i++) Assert.That(IsSame(lines[i], made[i]), made[i] + " is " + lines[i]);
        }

        static void Write(string path, List<string> made)
        {
            var lines = new List<string>(File.ReadAllLines(path)).FindAll(line => line.StartsWith('#'));
            lines.AddRange(made);
            File.WriteAllText(path, string.Join("\n", lines) + "\n");
        }

        // Ignores differences in the last digit, because processors may round differently.
        static bool IsSame(string a, string b)
        {
            string[] first = a.Split(' '), second = b.Split(' ');
            var isSame = first.Length == second.Length;
            for (var i = 0; isSame && i < first.Length; i++) isSame = first[i] == second[i] || Math.Abs(Number(first[i]) - Number(second[i])) < 3e-5;
            return isSame;
        }

        static double Number(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number : 1e9;

        static string Here([CallerFilePath] string here = "") => Path.GetDirectoryName(here);
    }
}
