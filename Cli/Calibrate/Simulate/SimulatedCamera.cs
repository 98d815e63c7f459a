using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Replay;
using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Determines position, light and motion of both codes for each picture of a sweep.</summary>
sealed class SimulatedCamera(SimulationSettings settings, SimulatedSweep sweep)
{
    const double MsPerTick = 1.0 / TimeSpan.TicksPerMillisecond;

    /// <summary>Maximum motion of the hand-held camera between two pictures, px.</summary>
    const double Shake = 2;

    /// <param name="defect">Name of the defect in the picture; empty if there is none.</param>
    public Shot Take(int picture, out string defect)
    {
        var random = new RandomStream(settings.Seed, purpose: -1 - picture);
        var place = new SimulatedPlace(picture / settings.PicturesPerPlace, settings.Seed);
        double dx = Shake * (random.Next() - 0.5), dy = Shake * (random.Next() - 0.5);
        var moment = sweep.Moments[picture];
        var (control, headset, motion) = settings.HeadLatencyMs is double latencyMs
            ? Turned(place, moment, latencyMs)
            : (Moved(place.Control, dx, dy), Moved(place.Headset, dx, dy), [0, 0]);
        var (controlLit, headsetLit) = (ControlLight(moment, control, headset), HeadsetLight(moment, headset));
        var shot = new Shot(
            SimulatedPlace.Width, SimulatedPlace.Height, place.Scene, place.SceneLight,
            [
                new DrawnCode(control, controlLit, place.ControlLight, place.Dot, place.Panel),
                new DrawnCode(headset, headsetLit, place.HeadsetLight, 0, null),
            ],
            place.Blur, motion, [], [], place.Noise, picture);
        defect = "";
        return random.Next() < settings.Spoiled ? PictureDefects.AddRandom(shot, random, out defect) : shot;
    }

    /// <summary>Moves both codes as seen by a camera that turns with the headset. The hologram follows the room.</summary>
    /// <remarks>
    /// On a real display, a lit frame stands still. Here it is blurred like the room, which makes it harder to read than in reality.
    /// </remarks>
    (double[][] Control, double[][] Headset, double[] Motion) Turned(SimulatedPlace place, SimulatedMoment moment, double latencyMs)
    {
        double middleX = (SimulatedPlace.Width - MeanOf(place.Control, 0) - MeanOf(place.Headset, 0)) / 2;
        double middleY = (SimulatedPlace.Height - MeanOf(place.Control, 1) - MeanOf(place.Headset, 1)) / 2;
        double[][] control = Moved(place.Control, middleX, middleY), headset = Moved(place.Headset, middleX, middleY);
        var delay = settings.ReadoutMs * (MeanOf(control, 1) - MeanOf(headset, 1)) / SimulatedPlace.Height;
        var room = HeadSwing.PlaceAt(moment.Middle + TimeSpan.FromMilliseconds(delay));
        var shown = HeadSwing.PlaceAt(sweep.LightOf(moment.Frame) - TimeSpan.FromMilliseconds(latencyMs));
        var speed = HeadSwing.SpeedAt(moment.Middle);
        var seconds = moment.ExposureMs / 1000;
        return (Moved(control, room.X, room.Y), Moved(headset, shown.X, shown.Y), [speed.X * seconds, speed.Y * seconds]);
    }

    static double MeanOf(double[][] corners, int axis) => corners.Average(corner => corner[axis]);

    /// <summary>Gets, for each cell, the share of the exposure for which it is lit. A rolling shutter exposes the rows one after another.</summary>
    double[] ControlLight(SimulatedMoment moment, double[][] corners, double[][] headset)
    {
        var lit = Ring(CodeKind.Control, 1);
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            var middle = MsOf(moment.Middle) + DelayMs(cell, corners, headset);
            var mean = CodeWords.MeanSign(pair, middle - moment.ExposureMs / 2, moment.ExposureMs);
            (lit[cell], lit[cell + 1]) = ((1 + mean) / 2, (1 - mean) / 2);
        }
        return lit;
    }

    double[] HeadsetLight(SimulatedMoment moment, double[][] corners)
    {
        var lit = new double[TimestampCode.CellCount];
        var drawn = new bool[TimestampCode.CellCount];
        for (var cell = 0; cell < lit.Length; cell++)
        {
            var middle = moment.Middle + TimeSpan.FromMilliseconds(DelayMs(cell, corners, corners));
            foreach (var (frame, share) in sweep.LightOf(moment, middle))
            {
                TimestampCode.Draw(TimestampCode.ValueOf(sweep.StartOf(frame)), CodeKind.Headset, drawn);
                if (drawn[cell]) lit[cell] += share;
            }
        }
        return lit;
    }

    /// <summary>Gets the delay between the exposure of the middle of the headset's code and the exposure of a cell, ms.</summary>
    double DelayMs(int cell, double[][] corners, double[][] headset)
    {
        double u = (cell % TimestampCode.Side + 0.5) / TimestampCode.Side, v = (cell / TimestampCode.Side + 0.5) / TimestampCode.Side;
        return settings.ReadoutMs * (HeightOf(corners, u, v) - HeightOf(headset, 0.5, 0.5)) / SimulatedPlace.Height;
    }

    static double HeightOf(double[][] corners, double u, double v) =>
        (1 - v) * ((1 - u) * corners[0][1] + u * corners[1][1]) + v * ((1 - u) * corners[3][1] + u * corners[2][1]);

    // The modulo keeps the fraction of a millisecond precise: a double has too few digits for the full time.
    static double MsOf(ControlTime time) => time.SinceEpoch.Ticks % (TimestampCode.PeriodMs * TimeSpan.TicksPerMillisecond) * MsPerTick;

    static double[] Ring(CodeKind kind, double light) =>
        [.. Enumerable.Range(0, TimestampCode.CellCount).Select(cell => TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, kind) ? light : 0)];

    static double[][] Moved(double[][] corners, double dx, double dy) => [.. corners.Select(corner => new[] { corner[0] + dx, corner[1] + dy })];
}
