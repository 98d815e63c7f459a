using System.Globalization;
using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.ControlSystem;

/// <summary>Interprets the subset of Structured Text (IEC 61131-3) used by the manual and the files of the LED matrix, directly from their text.</summary>
/// <remarks>
/// Supports integers, BOOL, LREAL (without division and with decimal arithmetic), zero-based arrays, a global variable list named GVL, the data of the
/// own task, assignments, IF with ELSIF, FOR, and calls of function blocks with named inputs. Each variable has the
/// range of its type. Anything else is an error that names the token.
/// </remarks>
sealed partial class StructuredText
{
    static readonly Dictionary<string, int> Bits = new()
    {
        ["BOOL"] = 1, ["BYTE"] = 8, ["WORD"] = 16, ["INT"] = 16, ["DWORD"] = 32, ["ULINT"] = 64,
    };

    /// <summary>Value of <see cref="Variable.BitCount"/> for LREAL.</summary>
    const int Real = -1;

    readonly List<string> _tokens;
    readonly Dictionary<string, Variable> _variables = [];
    readonly Dictionary<string, Func<ulong>> _functions;
    readonly Func<string, StructuredText> _blocks;
    readonly int _body;
    int _at;

    /// <param name="functions">Library functions without arguments, and data of the own task, by their complete names.</param>
    /// <param name="blocks">Creates an instance of a function block from the name of its type.</param>
    public StructuredText(string source, Dictionary<string, Func<ulong>> functions = null, Func<string, StructuredText> blocks = null)
    {
        _functions = functions ?? [];
        _blocks = blocks ?? (_ => null);
        _tokens = [.. Token().Matches(Comment().Replace(source, " ")).Select(match => match.Value)];
        _at = 2;
        while (Next.StartsWith("VAR", StringComparison.Ordinal)) Declare();
        _body = _at;
    }

    string Next => _tokens[_at];

    /// <summary>Gets or sets the value of a variable that is not an array.</summary>
    public decimal this[string name]
    {
        get => _variables[name].Values[0];
        set => _variables[name].Set(0, value);
    }

    public decimal[] Array(string name) => _variables[name].Values;

    /// <summary>Runs the body once, like one cycle of the PLC.</summary>
    public void Run()
    {
        _at = _body;
        Block(runs: true);
        if (!Next.StartsWith("END_", StringComparison.Ordinal)) throw Unknown();
    }

    [GeneratedRegex(@"\(\*.*?\*\)|\{.*?\}|//[^\n]*", RegexOptions.Singleline)]
    private static partial Regex Comment();

    // The data of the own task, and the variables of the global list, are one token.
    [GeneratedRegex(@"TwinCAT_SystemInfoVarList\._TaskInfo\[GETCURTASKINDEXEX\(\)\]\.\w+|GVL\.\w+|"
        + @"[A-Z]+#(16#)?[0-9A-F]+|%Q\*|[A-Za-z_]\w*|\d+(\.\d+(E-\d+)?)?|:=|<>|<=|>=|\.\.|\S")]
    private static partial Regex Token();

    // The program refers to the variables of a global list by the name of the list.
    void Declare()
    {
        var list = Take() == "VAR_GLOBAL" ? "GVL." : "";
        while (Next != "END_VAR")
        {
            var name = list + Take();
            if (TryTake("AT")) Take();
            Expect(":");
            _variables.Add(name, Type());
            if (TryTake(":=")) this[name] = Expression();
            Expect(";");
        }
        _at++;
    }

    Variable Type()
    {
        var length = 1UL;
        if (TryTake("ARRAY"))
        {
            foreach (var token in new[] { "[", "0", ".." }) Expect(token);
            length = ulong.Parse(Take()) + 1;
            foreach (var token in new[] { "]", "OF" }) Expect(token);
        }
        var type = Take();
        return Bits.TryGetValue(type, out var bits)
            ? new Variable(bits, new decimal[length], null)
            : type == "LREAL" ? new Variable(Real, new decimal[length], null) : new Variable(0, null, _blocks(type) ?? throw new FormatException("no type " + type));
    }

    void Block(bool runs)
    {
        while (!Next.StartsWith("END_", StringComparison.Ordinal) && Next is not ("ELSE" or "ELSIF"))
        {
            if (TryTake("IF")) If(runs);
            else if (TryTake("FOR")) For(runs);
            else Statement(runs);
        }
    }

    void If(bool runs)
    {
        var isTrue = Expression() != 0;
        Expect("THEN");
        Block(runs && isTrue);
        if (TryTake("ELSIF"))
        {
            If(runs && !isTrue);
            return;
        }
        if (TryTake("ELSE")) Block(runs && !isTrue);
        Expect("END_IF");
        Expect(";");
    }

    void For(bool runs)
    {
        var counter = _variables[Take()];
        Expect(":=");
        var first = Expression();
        Expect("TO");
        var last = Expression();
        Expect("DO");
        var body = _at;
        if (!runs) Block(false);
        for (var i = first; runs && i <= last; i++)
        {
            counter.Set(0, i);
            _at = body;
            Block(true);
        }
        Expect("END_FOR");
        Expect(";");
    }

    void Statement(bool runs)
    {
        var variable = _variables[Take()];
        if (TryTake("(")) Call(variable.Block, runs);
        else
        {
            var index = Index();
            Expect(":=");
            if (variable.Values.Length > 1 && index == null) Copy(variable, runs);
            else
            {
                var value = Expression();
                if (runs) variable.Set(index ?? 0, value);
            }
        }
        Expect(";");
    }

    void Call(StructuredText block, bool runs)
    {
        while (!TryTake(")"))
        {
            var input = Take();
            Expect(":=");
            block[input] = Expression();
            TryTake(",");
        }
        if (runs) block.Run();
    }

    // Copies a complete array, which is an output of a function block, to a variable.
    void Copy(Variable target, bool runs)
    {
        var block = _variables[Take()].Block;
        Expect(".");
        var source = block.Array(Take());
        if (runs) source.CopyTo(target.Values, 0);
    }

    int? Index()
    {
        if (!TryTake("[")) return null;
        var index = Expression();
        Expect("]");
        return (int)index;
    }

    // Level 0 contains the operators with the lowest precedence. The order of the levels is that of the standard.
    decimal Expression() => Binary(0);

    decimal Binary(int level)
    {
        string[][] levels = [["OR"], ["XOR"], ["AND"], ["=", "<>"], ["<", ">", "<=", ">="], ["+", "-"], ["*", "/", "MOD"]];
        if (level == levels.Length) return Unary();
        var value = Binary(level + 1);
        while (levels[level].Contains(Next)) value = Apply(Take(), value, Binary(level + 1));
        return value;
    }

    static decimal Apply(string sign, decimal a, decimal b) => sign switch
    {
        "OR" => (ulong)a | (ulong)b,
        "XOR" => (ulong)a ^ (ulong)b,
        "AND" => (ulong)a & (ulong)b,
        "=" => a == b ? 1 : 0,
        "<>" => a != b ? 1 : 0,
        "<" => a < b ? 1 : 0,
        ">" => a > b ? 1 : 0,
        "<=" => a <= b ? 1 : 0,
        ">=" => a >= b ? 1 : 0,
        "+" => a + b,
        "-" => a - b,
        "*" => a * b,
        "/" => (ulong)a / (ulong)b,
        _ => a % b,
    };

    decimal Unary()
    {
        // NOT supports only BOOL; other types would need their width.
        if (TryTake("NOT")) return 1 - Unary();
        if (TryTake("(")) return Closed(Expression());
        var token = Take();
        if (char.IsDigit(token[0])) return decimal.Parse(token, NumberStyles.Float, CultureInfo.InvariantCulture);
        if (token.Contains('#')) return Literal(token);
        if (token is "TRUE" or "FALSE") return token == "TRUE" ? 1UL : 0;
        if (token is "SHR" or "SHL") return Shift(token);
        if (TryTake("("))
        {
            if (_functions.TryGetValue(token, out var function)) return Closed(function());
            var target = token.Split("_TO_");
            if (target.Length == 2 && target[1] == "LREAL") return Closed(Expression());
            if (target.Length == 2 && Bits.TryGetValue(target[1], out var bits)) return Closed((ulong)Expression() & Mask(bits));
            throw Unknown();
        }
        if (token.Contains('.') && _functions.TryGetValue(token, out var datum)) return datum();
        if (!_variables.TryGetValue(token, out var variable)) throw Unknown();
        return variable.Values[Index() ?? 0];
    }

    decimal Shift(string direction)
    {
        Expect("(");
        var value = (ulong)Expression();
        Expect(",");
        var by = (int)Expression();
        return Closed(direction == "SHR" ? value >> by : value << by);
    }

    decimal Closed(decimal value)
    {
        Expect(")");
        return value;
    }

    static ulong Literal(string token)
    {
        var parts = token.Split('#');
        var value = Convert.ToUInt64(parts[^1], parts.Length == 3 ? 16 : 10);
        if (value > Mask(Bits[parts[0]])) throw new FormatException(token + " does not fit");
        return value;
    }

    string Take() => _tokens[_at++];

    bool TryTake(string token)
    {
        if (Next != token) return false;
        _at++;
        return true;
    }

    void Expect(string token)
    {
        if (!TryTake(token)) throw new FormatException($"'{token}' expected, but found '{Next}' after '{_tokens[_at - 1]}'");
    }

    FormatException Unknown() => new($"'{_tokens[_at - 1]} {Next}': this Structured Text is not supported");

    static ulong Mask(int bits) => ulong.MaxValue >> (64 - bits);

    sealed record Variable(int BitCount, decimal[] Values, StructuredText Block)
    {
        public void Set(int index, decimal value) => Values[index] = BitCount == Real ? value : (ulong)((Int128)value & Mask(BitCount));
    }
}
