using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>A camera position, with the corners and brightness of both codes as seen from it. Lengths in px; light is linear, 1 is white.</summary>
sealed class SimulatedPlace
{
    public const int Width = 1280, Height = 720;

    /// <summary>Range of a code's side length, px. The minimum is a tenth of the picture's height.</summary>
    const double MinSide = 72, MaxSide = 200;

    public SimulatedPlace(int number, int seed)
    {
        var random = new RandomStream(seed, purpose: 1000 + number);
        double Between(double a, double b) => a + (b - a) * random.Next();
        Scene = (int)(random.Next() * int.MaxValue);
        SceneLight = Between(0.3, 1);
        Blur = Between(0.4, 1.6);
        Noise = Between(1, 5);
        ControlLight = Between(0.3, 0.8);
        HeadsetLight = Between(0.15, 0.5);
        Dot = random.Next() < 0.6 ? Between(0.5, 0.85) : 0;
        Panel = random.Next() < 0.7 ? Between(0.01, 0.06) : null;
        double a = Between(MinSide, MaxSide), b = Between(MinSide, MaxSide);
        double apart = 0.8 * (a + b) + 10, angle = Between(-0.3, 0.3) + (random.Next() < 0.5 ? 0 : Math.PI);
        double x = Between(0.3, 0.7) * Width, y = Between(0.35, 0.65) * Height;
        Control = Code(x - apart / 2 * Math.Cos(angle), y - apart / 2 * Math.Sin(angle), a, Between);
        Headset = Code(x + apart / 2 * Math.Cos(angle), y + apart / 2 * Math.Sin(angle), b, Between);
    }

    public int Scene { get; }

    public double SceneLight { get; }

    public double Blur { get; }

    public double Noise { get; }

    public double ControlLight { get; }

    public double HeadsetLight { get; }

    public double Dot { get; }

    public double? Panel { get; }

    /// <summary>Corners of the control code, clockwise from the top left corner.</summary>
    public double[][] Control { get; }

    public double[][] Headset { get; }

    static double[][] Code(double x, double y, double side, Func<double, double, double> between)
    {
        double turn = between(-0.35, 0.35), tiltX = between(-0.08, 0.08), tiltY = between(-0.08, 0.08);
        double[] Corner(double u, double v)
        {
            var near = 1 + tiltX * u + tiltY * v;
            double px = side / 2 * u / near, py = side / 2 * v / near;
            return [x + px * Math.Cos(turn) - py * Math.Sin(turn), y + px * Math.Sin(turn) + py * Math.Cos(turn)];
        }
        return [Corner(-1, -1), Corner(1, -1), Corner(1, 1), Corner(-1, 1)];
    }
}
