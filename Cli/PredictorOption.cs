using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Prediction;

namespace Nowpose.Cli;

/// <summary><c>--predictor</c>: accepts the listed names, and polynomials with any history.</summary>
static class PredictorOption
{
    /// <param name="more">Text after the description.</param>
    /// <param name="standard">The default; null for none.</param>
    public static Option<string> Create(string more = "", string standard = Predictors.Default)
    {
        const string name = "--predictor";
        var list = string.Join(", ", Predictors.Names);
        var option = TextOption.Create(
            name, $"Prediction method [{list}; polynomials also with another history h, for example linear-h4]{more}", standard: standard);
        option.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<string>() is string value && !IsKnown(value))
                result.AddError(OptionValueMessages.UnknownPredictor(name, value, list));
        });
        return option;
    }

    static bool IsKnown(string predictor)
    {
        try
        {
            Predictors.Create(predictor, PredictionLimits.Unlimited);
            return true;
        }
        catch (InputException)
        {
            return false;
        }
    }
}
