using System.CommandLine;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Calibrate;

/// <summary>Creates the option with the former name of <c>--visu-ms</c>. Help does not show it.</summary>
static class FormerVisuOption
{
    const string Name = "--told-ms";

    /// <param name="present">The option with the current name. It is an error if the user gives both options.</param>
    public static Option<double?> Create(Option present)
    {
        var former = NumberOption.CreateOptional(Name, "Former name of " + present.Name, 0.0, 500, "ms");
        former.Hidden = true;
        former.Validators.Add(result =>
        {
            if (result.GetResult(present)?.Implicit == false) result.AddError(CalibrationMessages.BothNames(Name, present.Name));
        });
        return former;
    }
}
