namespace Nowpose.Cli;

/// <summary>Adds the place of an invalid input to the message about it.</summary>
static class InputPlace
{
    /// <param name="place">The file, with the line if it is known, or the option.</param>
    /// <exception cref="InputException">The function threw one; its message now begins with the place.</exception>
    public static T In<T>(string place, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (InputException fault)
        {
            throw new InputException($"{place}: {fault.Message}", fault);
        }
    }
}
