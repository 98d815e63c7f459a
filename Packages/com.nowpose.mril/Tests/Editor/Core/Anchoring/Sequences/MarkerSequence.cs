using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Runtime.CompilerServices;
using Nowpose.Anchoring;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Anchoring.Sequences
{
    /// <summary>Replays a stored sequence of sightings to a tracker at 60 frames per second.</summary>
    sealed class MarkerSequence
    {
        const double FrameSeconds = 1 / 60.0;
        static readonly TimeSpan Start = TimeSpan.FromSeconds(1000);

        readonly List<(double Time, MarkerSighting Sighting)> _lines = new List<(double, MarkerSighting)>();
        readonly Dictionary<string, (double Time, MarkerSighting Sighting)> _current = new Dictionary<string, (double, MarkerSighting)>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        int _next, _frame;

        public MarkerSequence(string file, [CallerFilePath] string here = "")
        {
            var markers = new List<BaseMarker>();
            foreach (var line in File.ReadAllLines(Path.Combine(Path.GetDirectoryName(here), file)))
            {
                var fields = line.Split(' ');
                if (fields[0] == "#") continue;
                if (fields[0] == "base") Base = Pose(fields, 1);
                else if (fields[0] == "marker") markers.Add(new BaseMarker(fields[1], Pose(fields, 2)));
                else _lines.Add((Number(fields[0]), Sighting(fields)));
            }
            Tracker.Use("recorded", markers);
        }

        public BaseTracker Tracker { get; } = new BaseTracker(new AnchoringSettings());

        /// <summary>The true pose of the base.</summary>
        public RigidTransform Base { get; }

        public double Seconds => _frame * FrameSeconds;

        public double OffMetres => Tracker.Base.Value.DistanceTo(Base);

        public double OffDegrees => Tracker.Base.Value.AngleTo(Base) * 180 / Math.PI;

        /// <param name="until">Seconds since the start.</param>
        public void Play(double until, Action seen = null)
        {
            for (; Seconds < until; seen?.Invoke())
            {
                _frame++;
                for (; _next < _lines.Count && _lines[_next].Time <= Seconds; _next++) _current[_lines[_next].Sighting.Payload] = _lines[_next];
                _sightings.Clear();
                // A sighting is removed when the file has not repeated it for 0.1 s.
                foreach (var (time, sighting) in _current.Values)
                    if (Seconds - time < 0.1) _sightings.Add(sighting);
                Tracker.Tick(new HeadsetTime(Start + Lengths.Seconds(Seconds)), _sightings, null, null);
            }
        }

        static MarkerSighting Sighting(string[] fields) => new MarkerSighting(
            "device " + fields[1], fields[1], Pose(fields, 4), 0, new HeadsetTime(Start + Lengths.Seconds(Number(fields[3]))),
            (MarkerTracking)(int)Number(fields[2]));

        /// <summary>Reads position and quaternion. Fields that are NaN result in an invalid pose.</summary>
        static RigidTransform Pose(string[] fields, int at)
        {
            double x = Number(fields[at + 3]), y = Number(fields[at + 4]), z = Number(fields[at + 5]), w = Number(fields[at + 6]);
            var s = 2 / (x * x + y * y + z * z + w * w);
            return new RigidTransform(
                1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
                s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
                s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y),
                Number(fields[at]), Number(fields[at + 1]), Number(fields[at + 2]));
        }

        static double Number(string text) => text == "nan" ? double.NaN : double.Parse(text, CultureInfo.InvariantCulture);
    }
}
