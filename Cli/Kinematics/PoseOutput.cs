using System.Globalization;
using System.Text;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Kinematics;

/// <summary>Formats link poses as text or JSON. The poses are row-major 4×4 matrices in the order of the model's links.</summary>
static class PoseOutput
{
    public static string Json(RobotModel model, double[][] poses) => JsonText.Of(
        new { Root = model.Root.Name, Links = model.Links.Zip(poses).ToDictionary(link => link.First.Name, link => link.Second) }, isIndented: false) + "\n";

    public static string Matrices(RobotModel model, double[][] poses)
    {
        var text = new StringBuilder(KinematicsMessages.Title(model.Name, model.Root.Name));
        for (var i = 0; i < poses.Length; i++)
        {
            text.Append('\n').Append(model.Links[i].Name).Append('\n');
            for (var row = 0; row < 4; row++) AppendRow(text, poses[i].AsSpan(4 * row, 4));
        }
        return text.ToString();
    }

    static void AppendRow(StringBuilder text, ReadOnlySpan<double> row)
    {
        foreach (var number in row)
        {
            // Adding 0.0 turns a negative zero after rounding into 0.
            text.Append(CultureInfo.InvariantCulture, $"{Math.Round(number, 6) + 0.0,13:0.000000}");
        }
        text.Append('\n');
    }
}
