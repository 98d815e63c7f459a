using System.CommandLine;

namespace Nowpose.Gateway.Options;

/// <summary>Creates options that take one of several words.</summary>
public static class ChoiceOption
{
    public static Option<string> Create(string name, string description, string standard, IReadOnlyCollection<string> allowed)
    {
        var list = string.Join(", ", allowed);
        var option = new Option<string>(name)
        {
            Description = $"{description} [{list}]",
            DefaultValueFactory = _ => standard,
        };
        option.Validators.Add(result =>
        {
            var value = result.GetValueOrDefault<string>();
            if (value != null && !allowed.Contains(value))
                result.AddError(OptionMessages.UnknownChoice(name, value, list));
        });
        return option;
    }
}
