using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>Tests the evaluation of rendered pictures in series. Needs Node.js, as the build does.</summary>
public sealed class VlcRunTests
{
    static PictureResult[] Read(SimulationSettings settings, IReadOnlyList<int> pictures)
    {
        var camera = new SimulatedCamera(settings, new SimulatedSweep(settings));
        var shots = pictures.Select(picture => PictureRequest.Made(camera.Take(picture, out _)));
        return [.. new VlcRun(new PictureReader(0, 0)).Run(shots, pictures.Count, place => $"{pictures[place]}", default).Pictures];
    }

    // The camera is at another place in each picture, so the code moves from picture to picture as if the headset turned.
    [Test]
    public void Run_PictureBetweenOthersAndAlone_HasTheSameResult()
    {
        var settings = new SimulationSettings { Pictures = 60, PicturesPerPlace = 1, Spoiled = 0, LoadSteps = 0, Seed = 5 };

        var among = Read(settings, [51, 52, 53])[1];
        var alone = Read(settings, [52])[0];

        Assert.That(alone.VisuMs, Is.EqualTo(37.3).Within(0.1));
        Assert.That((among.Fault, among.VisuMs), Is.EqualTo((alone.Fault, alone.VisuMs)));
    }

    [TestCase(0, false, PictureFaults.NoMargin)]
    [TestCase(0.25, false, PictureFaults.NoMargin)]
    [TestCase(1, false, null)]
    [TestCase(1, true, PictureFaults.PartlyCovered)]
    public void Run_WallCloseToTheLedsOrObjectInFrontOfThem_NamesTheCause(double marginCells, bool isCovered, string fault)
    {
        const double Left = 400, Top = 260, Side = 120, Cell = Side / TimestampCode.Side;
        var margin = marginCells * Cell;
        Cover[] objects = isCovered ? [new([Left + 0.3 * Side, Top + 0.3 * Side, 0.45 * Side, 0.35 * Side], 0.02)] : [];
        DrawnCode[] codes = [Code(CodeKind.Control, 40_000, Left, Top, Side), Code(CodeKind.Headset, 39_960, 760, Top, 140)];
        var shot = new Shot(1280, 720, 1, 0.4, codes, 0.8, [0, 0], [], [.. WallAround(Left - margin, Top - margin, Side + 2 * margin), .. objects], 2, 1);

        var read = new VlcRun(new PictureReader(0, 0)).Run([PictureRequest.Made(shot)], 1, _ => "", default).Pictures[0];

        Assert.That(read.Fault, Is.EqualTo(fault == null ? null : "control code " + fault));
    }

    static DrawnCode Code(CodeKind kind, int value, double left, double top, double side)
    {
        var lit = new bool[TimestampCode.CellCount];
        TimestampCode.Draw(value, kind, lit);
        double[][] corners = [[left, top], [left + side, top], [left + side, top + side], [left, top + side]];
        return new DrawnCode(corners, [.. lit.Select(each => each ? 1.0 : 0)], 0.5, 0, kind == CodeKind.Control ? 0.03 : null);
    }

    /// <summary>Returns a wall with a square opening.</summary>
    static Cover[] WallAround(double left, double top, double side)
    {
        const double Width = 70, Light = 0.3;
        return
        [
            new([left - Width, top - Width, side + 2 * Width, Width], Light), new([left - Width, top + side, side + 2 * Width, Width], Light),
            new([left - Width, top, Width, side], Light), new([left + side, top, Width, side], Light),
        ];
    }
}
