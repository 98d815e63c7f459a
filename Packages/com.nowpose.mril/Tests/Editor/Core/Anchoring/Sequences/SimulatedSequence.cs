using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Anchoring.Sequences
{
    /// <summary>Creates the lines of the sequence files for two markers. Each file simulates a known behaviour of devices.</summary>
    static class SimulatedSequence
    {
        const double Frame = 1 / 15.0, NoiseMetres = 0.001, NoiseRadians = 0.004;

        static readonly (double, double, double, double, double, double) Base = (0.9, -0.35, -0.6, 0.02, 0.002, 1.3);
        static readonly Dictionary<string, (double, double, double, double, double, double)> Markers =
            new Dictionary<string, (double, double, double, double, double, double)>
            {
                ["left"] = (0.15, 0.2, 0, 0, 0, 0.1), ["right"] = (0.15, -0.2, 0, 0, 0, -0.2),
            };

        /// <summary>Returns the lines of a file, without comments.</summary>
        public static List<string> LinesOf(string file)
        {
            var seed = 0;
            foreach (var letter in file) seed = (31 * seed + letter) % 1_000_003;
            var random = new Random(seed);
            var seconds = file == "noise.txt" || file == "two-disagree.txt" ? 8 : file == "lost-and-back.txt" ? 11 : 10;
            var lines = new List<string> { "base " + Numbers(Of(Base)) };
            foreach (var pair in Markers) lines.Add("marker " + pair.Key + " " + Numbers(Of(pair.Value)));
            var poses = new Dictionary<string, (double Seen, RigidTransform Pose)>();
            for (var i = 0; i * Frame < seconds; i++)
                foreach (var pair in Markers)
                {
                    var line = LineOf(file, i * Frame, pair.Key, poses, random);
                    if (line != null) lines.Add(line);
                }
            return lines;
        }

        // Returns the line for a marker and a frame; null if the device does not report the marker.
        static string LineOf(string file, double now, string name, Dictionary<string, (double Seen, RigidTransform Pose)> poses, Random random)
        {
            var isGone = file == "lost-and-back.txt" && now > 5 && now < 7;
            var isStale = file == "stale.txt" && now > 5;
            // The device reads each marker about six times per second.
            var isRead = random.NextDouble() < 0.4;
            var noise = Noise(random);
            var isOutlier = random.NextDouble() < 0.1;
            if (!poses.ContainsKey(name) || (isRead && !isGone && !isStale))
                poses[name] = (now, Of(Base) * PlaceOf(file, name, now) * noise * (isOutlier ? Outlier(random) : RigidTransform.Identity));
            var (seen, pose) = poses[name];
            if (isGone && now > 6) return null;
            var tracking = file == "lost-and-back.txt" && now > 4.5 && now < 7 ? 1 : 2;
            // While the headset corrects its map, the stale pose moves with the map.
            if (isStale) pose = RigidTransform.FromXyzRpy(0.25 * Math.Min(now - 5, 1), 0.1 * Math.Min(now - 5, 1), 0, 0, 0, 0) * pose;
            var start = Text(now, "0.000") + " " + name + " " + tracking + " ";
            if (file != "origin.txt") return start + Text(seen, "0.000") + " " + Numbers(pose);
            if (now < 0.5 || (now > 5 && now < 5.5)) return start + Text(now, "0.000") + " " + Numbers(RigidTransform.Identity);
            return now > 7 && now < 7.3
                ? start + Text(now, "0.000") + " nan nan nan nan nan nan nan"
                : start + Text(seen, "0.000") + " " + Numbers(pose);
        }

        static RigidTransform PlaceOf(string file, string name, double now)
        {
            var isOff = name == "right" && (file == "two-disagree.txt" || (file == "one-moved.txt" && now > 6));
            var off = RigidTransform.FromXyzRpy(0, file == "two-disagree.txt" ? -0.026 : 0.03, 0, 0, 0, 0);
            return isOff ? off * Of(Markers[name]) : Of(Markers[name]);
        }

        static RigidTransform Noise(Random random)
        {
            double Normal(double sd) => sd * (random.NextDouble() + random.NextDouble() + random.NextDouble() + random.NextDouble() - 2) * 1.732;
            return RigidTransform.FromXyzRpy(
                Normal(NoiseMetres), Normal(NoiseMetres), Normal(NoiseMetres), Normal(NoiseRadians), Normal(NoiseRadians), Normal(NoiseRadians));
        }

        // Returns a wrong pose: at another position, or turned about the line of sight.
        static RigidTransform Outlier(Random random) => random.NextDouble() < 0.5
            ? RigidTransform.FromXyzRpy(0.08, 0, 0.05, 0, 0, 0)
            : RigidTransform.FromXyzRpy(0, 0, 0, 0, 0, 1.6);

        static RigidTransform Of((double X, double Y, double Z, double Roll, double Pitch, double Yaw) p) =>
            RigidTransform.FromXyzRpy(p.X, p.Y, p.Z, p.Roll, p.Pitch, p.Yaw);

        static string Numbers(RigidTransform p)
        {
            // No pose here is near half a turn about x or y, so w is not near zero.
            var w = Math.Sqrt(1 + p.R00 + p.R11 + p.R22) / 2;
            double x = (p.R21 - p.R12) / (4 * w), y = (p.R02 - p.R20) / (4 * w), z = (p.R10 - p.R01) / (4 * w);
            return Text(p.X, "0.00000") + " " + Text(p.Y, "0.00000") + " " + Text(p.Z, "0.00000") + " " + Text(x, "0.000000") + " "
                + Text(y, "0.000000") + " " + Text(z, "0.000000") + " " + Text(w, "0.000000");
        }

        static string Text(double number, string format) => number.ToString(format, CultureInfo.InvariantCulture);
    }
}
