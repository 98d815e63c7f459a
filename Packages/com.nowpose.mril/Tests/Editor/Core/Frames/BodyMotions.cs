using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Simulation;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Simulated motions of rigid bodies: a pose for each time in s.</summary>
    static class BodyMotions
    {
        public static readonly Vector3D Velocity = new Vector3D(0.3, -0.2, 0.1);

        /// <summary>An object that rotates at a constant rate about a fixed axis while it moves along a line.</summary>
        /// <param name="rate">Angular velocity about the body's axes, rad/s.</param>
        public static Func<double, PoseSample> Constant(Vector3D rate)
        {
            var start = UnitQuaternion.Exp(new Vector3D(0.4, -1, 0.2));
            return t => new PoseSample(t, new Vector3D(1, 2, 3) + Velocity * t, start * UnitQuaternion.Exp(rate * t));
        }

        /// <summary>A hand-held object. Each component is a sum of sines up to 1 Hz.</summary>
        public static PoseSample HandHeld(double t)
        {
            double Wave(double a, double b, double c) => Math.Sin(a * t) + 0.5 * Math.Sin(b * t + 1) + 0.2 * Math.Sin(c * t + 2);
            var position = new Vector3D(0.1 * Wave(1.3, 2.9, 5.1), 0.1 * Wave(0.9, 3.3, 6.1), 0.05 * Wave(1.7, 2.1, 4.7));
            return new PoseSample(t, position, UnitQuaternion.Exp(new Vector3D(0.3 * Wave(1.1, 3.1, 4.3), 0, 0))
                * UnitQuaternion.Exp(new Vector3D(0, 0.3 * Wave(0.7, 2.3, 5.9), 0.4 * Wave(1.9, 2.7, 3.9))));
        }

        /// <summary>A turntable that repeatedly makes a quarter turn in 2 s and then rests for 2 s.</summary>
        public static PoseSample Turntable(double t)
        {
            var share = Math.Min(1, t % 4 / 2);
            var angle = Math.PI / 2 * (Math.Floor(t / 4) + share * share * share * (10 + share * (6 * share - 15)));
            return new PoseSample(
                t, new Vector3D(0.5 * Math.Cos(angle), 0.5 * Math.Sin(angle), 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, angle)));
        }

        /// <summary>An object on a conveyor that repeatedly rests for 1.5 s and then moves for 2.5 s, at 0.3 m/s with ramps of 0.1 s.</summary>
        public static PoseSample Conveyor(double t)
        {
            const double rest = 1.5, move = 2.5, ramp = 0.1, speed = 0.3;
            var u = Math.Max(0, t % (rest + move) - rest);
            var way = u < ramp ? u * u / (2 * ramp) : u < move - ramp ? u - ramp / 2 : move - ramp - (move - u) * (move - u) / (2 * ramp);
            var x = speed * (Math.Floor(t / (rest + move)) * (move - ramp) + way);
            return new PoseSample(t, new Vector3D(x, 0.2, 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, 0.4)));
        }

        /// <summary>An object on a conveyor whose three moves have different lengths, with constant acceleration in their first and last 15 %.</summary>
        public static PoseSample UnequalMoves(double t)
        {
            var moves = new[] { (2.3, 0.55), (1.7, 0), (3.1, 0.9), (0.9, 0), (1.2, 0.2), (2.7, 0) };
            const double cycle = 11.9, way = 1.65, ramp = 0.15;
            var (x, rest) = (way * Math.Floor(t / cycle), t % cycle);
            foreach (var (seconds, metres) in moves)
            {
                var u = Math.Min(1, rest / seconds);
                var v = Math.Min(u, 1 - u);
                var share = v < ramp ? v * v / (2 * ramp) : v - ramp / 2;
                x += metres * (u < 0.5 ? share : 1 - ramp - share) / (1 - ramp);
                if (rest <= seconds) break;
                rest -= seconds;
            }
            return new PoseSample(t, new Vector3D(x, 0.2, 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, 0.35)));
        }

        /// <summary>
        /// A vehicle whose yaw rate changes every 2.5 s, at 2 rad/s², to another of three values; no sequence of values repeats within 20 s.
        /// </summary>
        public static PoseSample Vehicle(double t)
        {
            var rates = new[] { 0, 0.8, 0, -0.8, 0.8, 0, 0.8, -0.8, 0 };
            const double period = 2.5, acceleration = 2;
            var angle = 0.0;
            for (var i = 1; i < rates.Length && t > (i - 1) * period; i++)
            {
                var s = Math.Min(period, t - (i - 1) * period);
                var ramp = Math.Abs(rates[i] - rates[i - 1]) / acceleration;
                var inRamp = Math.Min(s, ramp);
                angle += rates[i - 1] * inRamp + Math.Sign(rates[i] - rates[i - 1]) * acceleration * inRamp * inRamp / 2 + rates[i] * (s - inRamp);
            }
            return new PoseSample(
                t, new Vector3D(0.5 * Math.Sin(0.9 * t), 0.3 * Math.Cos(1.1 * t), 0.1), UnitQuaternion.Exp(new Vector3D(0, 0, angle)));
        }

        /// <summary>
        /// A vehicle that drives on a line, measured with a resolution of 1 nm, and turns twice, at up to 0.8 rad/s with ramps of 0.3 s: first after 8 s.
        /// </summary>
        public static PoseSample FirstTurns(double t)
        {
            double x = 0, y = 0, heading = 0;
            const double step = 0.002;
            for (var time = 0.0; time < t; time += step)
            {
                var seconds = Math.Min(step, t - time);
                double Rate(double start) => Math.Max(0, Math.Min(1, Math.Min((time - start) / 0.3, (start + 1.8 - time) / 0.3)));
                heading += 0.8 * seconds * (Rate(8.02) - Rate(13.41));
                (x, y) = (x + seconds * Math.Cos(heading), y + seconds * Math.Sin(heading));
            }
            return new PoseSample(t, new Vector3D(Math.Round(x, 9), Math.Round(y, 9), 0.1), UnitQuaternion.Exp(new Vector3D(0, 0, heading)));
        }

        /// <summary>An object that rests for 8 s and then moves at 0.6 m/s at once, 2 ms before a sample at intervals of 20, 50 or 100 ms.</summary>
        public static PoseSample SwitchedOn(double t) =>
            new PoseSample(t, new Vector3D(0.6 * Math.Max(0, t - 7.998), 0.2, 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, 0.4)));

        /// <summary>A table that is switched on and off: it has its full rate at once, and stands at once.</summary>
        public static PoseSample Switched(double t)
        {
            // The table turns for 0.6 to 3 s and stands for 0.4 to 2.8 s; the times of the changes do not repeat.
            double begin = 0, angle = 0;
            for (var i = 0; ; i++)
            {
                double rest = 1.6 + 1.2 * Math.Sin(3 * i), turn = 1.8 + 1.2 * Math.Cos(5 * i);
                var turned = Math.Min(Math.Max(t - begin - rest, 0), turn);
                if (t < begin + rest + turn)
                {
                    angle += 1.2 * turned;
                    break;
                }
                begin += rest + turn;
                angle += 1.2 * turn;
            }
            return new PoseSample(t, new Vector3D(0.3 * Math.Cos(angle), 0.3 * Math.Sin(angle), 0.8), UnitQuaternion.Exp(new Vector3D(0, 0, angle)));
        }

        /// <summary>
        /// A vehicle that drives at 0.6 m/s, turns in place at 0.5 rad/s in either direction, and stands, for times that do not repeat. Its speed changes
        /// at once.
        /// </summary>
        public static PoseSample AbruptVehicle(double t)
        {
            double x = 0, y = 0, heading = 0, left = t;
            for (var i = 0; left > 0; i++)
            {
                var seconds = Math.Min(left, 1.6 + 1.1 * Math.Sin(3 * i * i + 1));
                left -= seconds;
                if (i % 3 == 0) (x, y) = (x + 0.6 * seconds * Math.Cos(heading), y + 0.6 * seconds * Math.Sin(heading));
                if (i % 3 == 1) heading += (i % 2 == 0 ? 0.5 : -0.5) * seconds;
            }
            return new PoseSample(t, new Vector3D(x, y, 0.1), UnitQuaternion.Exp(new Vector3D(0, 0, heading)));
        }

        /// <summary>An object on a conveyor that moves at 0.3 m/s at once or stands at once, for random times of 0.4 to 3.4 s.</summary>
        public static Func<double, PoseSample> SwitchedConveyor(int seed) => t =>
        {
            var random = new Random(seed);
            double x = 0, left = t;
            for (var i = 0; left > 0; i++)
            {
                var seconds = Math.Min(left, 0.4 + 3 * random.NextDouble());
                left -= seconds;
                if (i % 2 == 0) x += 0.3 * seconds;
            }
            return new PoseSample(t, new Vector3D(x, 0.2, 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, 0.4)));
        };

        /// <summary>A workpiece on a conveyor, 0.3 m/s, that reappears at the start of the conveyor after each 2 m.</summary>
        public static PoseSample Reappearing(double t) =>
            new PoseSample(t, new Vector3D(0.3 * t % 2, 0.2, 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, 0.4)));

        /// <summary>An object that moves straight ahead while a planar tracker measures it with noise of 1 mm and 0.1°.</summary>
        public static PoseSample NoisyHeading(double t)
        {
            var random = new Random(76 + (int)Math.Round(t * 1000));
            var scatter = new Vector3D(0.001 * random.NextNormal(), 0.001 * random.NextNormal(), 0);
            return new PoseSample(t, Velocity * t + scatter, UnitQuaternion.Exp(new Vector3D(0, 0, 0.0017 * random.NextNormal())));
        }

        /// <summary>An object on a turntable whose angular velocity jumps, within one sample, to zero or back, every 3.3 s.</summary>
        public static PoseSample JumpingRate(double t)
        {
            const double period = 6.6;
            double Turned(double s) => 0.5 * s + 0.25 * Math.Sin(0.9 * s);
            var (rounds, rest) = (Math.Floor(t / period), t % period);
            var angle = Turned(rounds * period / 2 + Math.Min(rest, period / 2));
            return new PoseSample(t, new Vector3D(0.5 * Math.Cos(angle), 0.5 * Math.Sin(angle), 0.9), UnitQuaternion.Exp(new Vector3D(0, 0, angle)));
        }

        /// <summary>An object at rest.</summary>
        public static PoseSample Rest(double t) =>
            new PoseSample(t, new Vector3D(0.1, 0.2, 0.3), UnitQuaternion.Exp(new Vector3D(0.2, 0.3, 1.2)));

        /// <summary>Adds the noise of a tracker, 1 mm and 0.1° in each component, and reverses the sign of every third quaternion.</summary>
        public static Func<double, PoseSample> WithNoise(Func<double, PoseSample> motion, int seed) => t =>
        {
            var sample = motion(t);
            // The noise depends only on the time, so that each call for a time returns the same sample.
            var random = new Random(seed + (int)Math.Round(t * 1000));
            Vector3D Vector(double deviation) => new Vector3D(deviation * random.NextNormal(), deviation * random.NextNormal(), deviation * random.NextNormal());
            var position = sample.Position + Vector(0.001);
            var rotation = sample.Rotation * UnitQuaternion.Exp(Vector(0.0017));
            return new PoseSample(t, position, random.Next(3) == 0 ? Negated(rotation) : rotation);
        };

        public static Vector3D PositionAt(this BodyPredictor body, double time)
        {
            var pose = body.At(time);
            return new Vector3D(pose.X, pose.Y, pose.Z);
        }

        public static UnitQuaternion Negated(in UnitQuaternion q)
        {
            UnitQuaternion.TryNormalise(-q.X, -q.Y, -q.Z, -q.W, out var negated);
            return negated;
        }
    }
}
