using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Simulation;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>
    /// Simulates a robot base with markers, and a device that reports the markers at 30 Hz with noise and outliers. Frames run at 60 Hz.
    /// </summary>
    sealed class SimulatedMarkers
    {
        const double FrameSeconds = 1 / 60.0;

        readonly Random _random;
        readonly List<BaseMarker> _markers = new List<BaseMarker>();
        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        readonly Dictionary<string, RigidTransform> _seen = new Dictionary<string, RigidTransform>();
        readonly Dictionary<string, HeadsetTime> _times = new Dictionary<string, HeadsetTime>();
        readonly Dictionary<string, RigidTransform> _turned = new Dictionary<string, RigidTransform>();
        int _frame;

        public SimulatedMarkers(int seed, AnchoringSettings settings = null)
        {
            _random = new Random(seed);
            Tracker = new BaseTracker(settings ?? new AnchoringSettings());
            Base = RigidTransform.FromXyzRpy(1.2, -0.4, -0.7, 0.02, -0.03, 2.1);
        }

        public BaseTracker Tracker { get; }

        /// <summary>The true pose of the base.</summary>
        public RigidTransform Base { get; set; }

        /// <summary>RMS of the position noise in m. <see cref="NoiseDegrees"/> is the RMS of the angle noise.</summary>
        public double NoiseMetres { get; set; }

        public double NoiseDegrees { get; set; }
        public double OutlierShare { get; set; }

        /// <summary>RMS of the constant angle error of the markers' prints, in degrees.</summary>
        public double PrintDegrees { get; set; }

        /// <summary>Turn, in the base frame, that the device adds to the rotations of all prints.</summary>
        public RigidTransform CommonTurn { get; set; } = RigidTransform.Identity;

        public FakeAnchors Anchors { get; set; }
        public RigidTransform? Head { get; set; } = RigidTransform.FromXyzRpy(1.2, -0.4, 0.3, 0, Math.PI / 2, 0);
        public double Seconds => _frame * FrameSeconds;
        public HeadsetTime Now => HeadsetTime.FromSeconds(100 + Seconds);

        /// <summary>Selects the codes that are in view. By default, all codes are in view.</summary>
        public Func<string, bool> IsInView { get; set; } = _ => true;

        /// <summary>Function that changes a sighting before the device reports it. By default, sightings are not changed.</summary>
        public Func<MarkerSighting, MarkerSighting> Change { get; set; } = sighting => sighting;

        /// <summary>True poses, in the base frame, of markers that are not at their configured place.</summary>
        public Dictionary<string, RigidTransform> Shifted { get; } = new Dictionary<string, RigidTransform>();

        /// <summary>Creates a base with a single marker.</summary>
        public static SimulatedMarkers One(int seed, double offsetMetres, AnchoringSettings settings = null)
        {
            var cell = new SimulatedMarkers(seed, settings);
            cell.Use(("a", RigidTransform.FromXyzRpy(offsetMetres, 0, 0, 0, 0, 0.4)));
            return cell;
        }

        /// <summary>
        /// Creates a base with three markers at the corners of a triangle with edges of 0.3 m. The centre of the triangle is on the x axis of
        /// the base.
        /// </summary>
        public static SimulatedMarkers Three(int seed, double offsetMetres = 0, AnchoringSettings settings = null)
        {
            var cell = new SimulatedMarkers(seed, settings);
            var radius = 0.3 / Math.Sqrt(3);
            cell.Use(
                ("a", RigidTransform.FromXyzRpy(offsetMetres + radius, 0, 0, 0, 0, 0.4)),
                ("b", RigidTransform.FromXyzRpy(offsetMetres - radius / 2, 0.15, 0, 0, 0, 2)),
                ("c", RigidTransform.FromXyzRpy(offsetMetres - radius / 2, -0.15, 0, 0, 0, -1)));
            return cell;
        }

        /// <summary>Creates a base with markers on a circle around it, all with the same rotation.</summary>
        public static SimulatedMarkers Ring(int count, int seed)
        {
            var cell = new SimulatedMarkers(seed);
            var (markers, radius) = (new (string, RigidTransform)[count], 0.3 / Math.Sqrt(3));
            for (var i = 0; i < count; i++)
            {
                var angle = 2 * Math.PI * i / count;
                markers[i] = ("m" + i, RigidTransform.FromXyzRpy(radius * Math.Cos(angle), radius * Math.Sin(angle), 0, 0, 0, 0));
            }
            cell.Use(markers);
            return cell;
        }

        public void Use(params (string Payload, RigidTransform InBase)[] markers)
        {
            _markers.Clear();
            foreach (var (payload, inBase) in markers) _markers.Add(new BaseMarker(payload, inBase));
            Tracker.Use("cell", _markers);
        }

        public void Noisy()
        {
            (NoiseMetres, NoiseDegrees, OutlierShare) = (0.002, 0.5, 0.1);
        }

        /// <summary>Makes the device see its only code at an interval, and report it with a delay, both in s.</summary>
        public void ReportRarely(double interval, double delay)
        {
            var (seen, last, reported) = (new Queue<MarkerSighting>(), default(MarkerSighting), default(MarkerSighting));
            Change = now =>
            {
                if (now.LastSeen - last.LastSeen >= Lengths.Seconds(interval)) seen.Enqueue(last = now);
                while (seen.Count > 0 && Now - seen.Peek().LastSeen >= Lengths.Seconds(delay)) reported = seen.Dequeue();
                return reported;
            };
        }

        /// <summary>Lets time pass without frames, as while the headset is suspended.</summary>
        public void Pause(double seconds) => _frame += (int)Math.Round(seconds / FrameSeconds);

        public void Run(double seconds, Action seen = null)
        {
            for (var end = Seconds + seconds - 1e-9; Seconds < end; seen?.Invoke()) Frame();
        }

        /// <returns>Seconds until the lock; null if the base was not locked.</returns>
        public double? RunUntilLocked(double atMost)
        {
            var start = Seconds;
            while (Seconds - start < atMost)
            {
                Frame();
                if (Tracker.State == BaseAnchorState.Locked) return Seconds - start;
            }
            return null;
        }

        public void Frame()
        {
            _frame++;
            _sightings.Clear();
            foreach (var marker in _markers)
            {
                if (IsInView(marker.Payload) && (_frame % 2 == 0 || !_seen.ContainsKey(marker.Payload))) See(marker);
                if (!_seen.TryGetValue(marker.Payload, out var pose)) continue;
                _sightings.Add(Change(new MarkerSighting(
                    "id of " + marker.Payload, marker.Payload, pose, 0, _times[marker.Payload], MarkerTracking.Tracking)));
            }
            Tracker.Tick(Now, _sightings, Head, Anchors);
        }

        /// <summary>Returns the error of the locked base: the distance at a point on its x axis, and the angle.</summary>
        public (double Metres, double Degrees) ErrorAt(double reachMetres = 0)
        {
            var reach = RigidTransform.FromXyzRpy(reachMetres, 0, 0, 0, 0, 0);
            var locked = Tracker.Base.Value;
            return ((locked * reach).DistanceTo(Base * reach), locked.AngleTo(Base) * 180 / Math.PI);
        }

        void See(BaseMarker marker)
        {
            if (!_turned.TryGetValue(marker.Payload, out var turned)) _turned[marker.Payload] = turned = Noise(0, PrintDegrees);
            var inBase = Shifted.TryGetValue(marker.Payload, out var shifted) ? shifted : marker.MarkerInBase;
            var noise = _random.NextDouble() < OutlierShare ? Noise(0.1, 30) : Noise(NoiseMetres, NoiseDegrees);
            var place = CommonTurn.MovedTo(inBase.X, inBase.Y, inBase.Z) * inBase.MovedTo(0, 0, 0);
            _seen[marker.Payload] = Base * place * turned * noise;
            _times[marker.Payload] = Now;
        }

        RigidTransform Noise(double metres, double degrees)
        {
            double m = metres / Math.Sqrt(3), r = degrees * Math.PI / 180 / Math.Sqrt(3);
            return PoseNumbers.Turn(r * Normal(), r * Normal(), r * Normal()).MovedTo(m * Normal(), m * Normal(), m * Normal());
        }

        double Normal() => _random.NextNormal();
    }
}
