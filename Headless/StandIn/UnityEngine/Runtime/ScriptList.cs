namespace UnityEngine;

/// <summary>
/// Scripts in execution order; scripts with the same execution order in the order in which they were added. The list may change during an iteration.
/// </summary>
sealed class ScriptList
{
    readonly List<MonoBehaviour> _places = new();
    readonly List<MonoBehaviour> _arriving = new();
    bool _hasGaps;

    /// <summary>Number of entries, including the empty entries of removed scripts.</summary>
    internal int Size => _places.Count;

    internal MonoBehaviour this[int index] => _places[index];

    /// <summary>Adds a script. The next pass is the first one that includes it.</summary>
    internal void Add(MonoBehaviour script) => _arriving.Add(script);

    /// <summary>Removes a script. A pass in progress skips it.</summary>
    internal void Remove(MonoBehaviour script)
    {
        if (_arriving.Remove(script)) return;

        var index = _places.IndexOf(script);
        if (index < 0) return;

        _places[index] = null;
        _hasGaps = true;
    }

    internal void BeginPass()
    {
        if (_hasGaps)
        {
            // Removes the empty entries. RemoveAll is not used, because its delegate would allocate.
            var kept = 0;
            for (var i = 0; i < _places.Count; i++)
            {
                if (_places[i] is not null) _places[kept++] = _places[i];
            }

            _places.RemoveRange(kept, _places.Count - kept);
            _hasGaps = false;
        }

        foreach (var script in _arriving) _places.Insert(PlaceOf(script), script);
        _arriving.Clear();
    }

    int PlaceOf(MonoBehaviour script)
    {
        var order = script.Script.Order;
        var index = _places.Count;
        while (index > 0 && _places[index - 1].Script.Order > order) index--;
        return index;
    }
}
