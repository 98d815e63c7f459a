using Nowpose.Latency.Conditions;
using Nowpose.Messages;

namespace Nowpose.Latency
{
    /// <summary>A display condition whose value on a device differs from its value at the calibration.</summary>
    public sealed class ConditionMismatch
    {
        internal ConditionMismatch(DisplayCondition condition, string calibrated, string actual)
        {
            Condition = condition;
            Calibrated = calibrated;
            Actual = actual;
            Words = WordsOf();
        }

        internal DisplayCondition Condition { get; }

        /// <summary>Name of the condition's field in files.</summary>
        public string Field => DisplayConditionNames.FieldOf(Condition);

        /// <summary>Name of the condition in messages.</summary>
        public string Label => DisplayConditionNames.LabelOf(Condition);

        /// <summary>Value of the condition at the calibration.</summary>
        public string Calibrated { get; }

        /// <summary>Value of the condition on this device.</summary>
        public string Actual { get; }

        /// <summary>
        /// Whether the mismatch prevents the use of the profile. True for another device or refresh rate, because L_visu depends on both.
        /// </summary>
        public bool IsRefusal => Condition == DisplayCondition.Device || Condition == DisplayCondition.DisplayRate;

        /// <summary>Message in one line: the condition, both values, and the action to take.</summary>
        public string Words { get; }

        string WordsOf()
        {
            switch (Condition)
            {
                case DisplayCondition.Device: return ConditionMessages.OtherDevice(Calibrated, Actual);
                case DisplayCondition.DisplayRate: return ConditionMessages.OtherRate(Calibrated, Actual);
                default: return ConditionMessages.Other(Label, Calibrated, Actual, DisplayConditionNames.PlaceOf(Condition));
            }
        }
    }
}
