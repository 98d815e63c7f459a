using System;

namespace Nowpose.Prediction.Stacking
{
    /// <summary>The forecasts that are mixed: the paper's polynomials, and Gaussian processes of four length scales.</summary>
    sealed class Forecasters
    {
        public const int Hold = 0;
        public const int Linear = 1;
        public const int Count = 11;

        /// <summary>By the velocity, and the acceleration, that the newest sample tells; without them the stopping quadratic.</summary>
        const int Told = 10;

        const int BestProcess = 6;

        /// <summary>What a line has of the prior: on real machines' first moves a process alone swings out further.</summary>
        const double ShareOfLine = 0.4;

        /// <summary>What the told velocity and acceleration have of the prior; a smooth motion knows its course further ahead.</summary>
        const double ShareOfTold = 0.7;

        /// <summary>After a shock that did not speed up, half the way is believed.</summary>
        const double ShareAfterShock = 0.5;

        const int FirstPolynomial = 2;
        const int FirstProcess = 5;

        readonly PolynomialSection[] _polynomials = { new PolynomialSection(2, 3), new PolynomialSection(3, 4), new PolynomialSection(2, 5) };
        readonly int[] _polynomialSamples = { 3, 4, 5 };

        readonly GaussianProcess[] _processes =
        {
            new GaussianProcess(0.4, 1e-7, 5), new GaussianProcess(0.6, 1e-7, 5), new GaussianProcess(1, 1e-7, 5),
            new GaussianProcess(2, 1e-7, 5), new GaussianProcess(0.6, 1e-5, 8),
        };

        /// <summary>The weights while nothing is known: mostly the process with l = 0.6 s, the best single forecast on clean moves.</summary>
        public static double[] Prior()
        {
            var weights = new double[Count];
            weights[Linear] = ShareOfLine;
            weights[BestProcess] = 1 - ShareOfLine;
            return weights;
        }

        /// <summary>The weights to stay near when samples tell their acceleration.</summary>
        public static double[] PriorWhenTold()
        {
            var weights = new double[Count];
            weights[BestProcess] = 1 - ShareOfTold;
            weights[Told] = ShareOfTold;
            return weights;
        }

        /// <summary>The weights of one forecast alone.</summary>
        public static double[] Only(int forecast)
        {
            var weights = new double[Count];
            weights[forecast] = 1;
            return weights;
        }

        /// <summary>Fills all tables, one after another.</summary>
        /// <param name="connected">How many of the newest samples follow each other without a gap.</param>
        /// <param name="available">How many of the newest samples belong to one motion, at least 1.</param>
        /// <param name="hasGrown">Whether the shock before the newest sample sped the motion up.</param>
        public void Forecast(SampleHistory history, int connected, int available, bool hasGrown, double[] tables)
        {
            Array.Clear(tables, 0, tables.Length);
            if (connected < 2) return;
            var samples = Math.Min(connected, available);
            var speed = (history[0].Position - history[1].Position) / (history[0].Time - history[1].Time);
            if (samples <= 2)
            {
                var share = samples == 1 && !hasGrown ? ShareAfterShock : 1;
                for (var i = 1; i < Count; i++) FillLine(tables, i, speed * share);
                return;
            }
            FillLine(tables, Linear, speed);
            if (double.IsNaN(history[0].Velocity)) FillStopping(history, tables, Told);
            else FillTold(history, tables);
            for (var i = 0; i < _polynomials.Length; i++)
                if (samples < _polynomialSamples[i]) FillStopping(history, tables, FirstPolynomial + i);
                else FillPolynomial(history, tables, i);
            for (var i = 0; i < _processes.Length; i++)
                if (samples < _processes[i].Samples) FillStopping(history, tables, FirstProcess + i);
                else FillProcess(history, tables, i);
        }

        /// <summary>Forgets the rhythm of the samples.</summary>
        public void Reset()
        {
            foreach (var process in _processes) process.Reset();
        }

        static void FillLine(double[] tables, int forecast, double speed)
        {
            var start = forecast * ForecastGrid.Points;
            for (var i = 0; i < ForecastGrid.Points; i++) tables[start + i] = speed * (i * ForecastGrid.Step);
        }

        void FillPolynomial(SampleHistory history, double[] tables, int index)
        {
            var section = _polynomials[index];
            section.Solve(history, _polynomialSamples[index]);
            var start = (FirstPolynomial + index) * ForecastGrid.Points;
            for (var i = 0; i < ForecastGrid.Points; i++) tables[start + i] = section.At(i * ForecastGrid.Step);
        }

        void FillProcess(SampleHistory history, double[] tables, int index)
        {
            var start = (FirstProcess + index) * ForecastGrid.Points;
            _processes[index].Forecast(history, tables, start);
            StopAtReversal(tables, start, Math.Sign(history[0].Position - history[1].Position));
        }

        /// <summary>Drives brake to rest far more often than they turn: a forecast that turns back stands from there on.</summary>
        static void StopAtReversal(double[] tables, int start, int direction)
        {
            for (var i = 1; i < ForecastGrid.Points; i++)
            {
                if ((tables[start + i] - tables[start + i - 1]) * direction > 0) continue;
                for (var rest = i; rest < ForecastGrid.Points; rest++) tables[start + rest] = tables[start + i - 1];
                return;
            }
        }

        /// <summary>The quadratic through the newest three samples, which stops at its vertex.</summary>
        static void FillStopping(SampleHistory history, double[] tables, int forecast)
        {
            var start = forecast * ForecastGrid.Points;
            var h1 = history[1].Time - history[0].Time;
            var h2 = history[2].Time - history[0].Time;
            var s1 = (history[1].Position - history[0].Position) / h1;
            var s2 = (history[2].Position - history[0].Position) / h2;
            var bend = (s1 - s2) / (h1 - h2);
            var speed = s1 - bend * h1;
            var direction = Math.Sign(history[0].Position - history[1].Position);
            if (speed * direction <= 0)
            {
                Array.Clear(tables, start, ForecastGrid.Points);
                return;
            }
            FillParabola(tables, start, speed, bend);
        }

        // Taylor's series; a velocity alone makes one with the sample before, as Hermite's quadratic.
        static void FillTold(SampleHistory history, double[] tables)
        {
            ref readonly var newest = ref history[0];
            var interval = newest.Time - history[1].Time;
            var bend = double.IsNaN(newest.Acceleration)
                ? (newest.Velocity - (newest.Position - history[1].Position) / interval) / interval
                : newest.Acceleration / 2;
            FillParabola(tables, Told * ForecastGrid.Points, newest.Velocity, bend);
        }

        // Stops at its vertex.
        static void FillParabola(double[] tables, int start, double speed, double bend)
        {
            var stop = speed * bend < 0 ? -speed / (2 * bend) : double.PositiveInfinity;
            for (var i = 0; i < ForecastGrid.Points; i++)
            {
                var x = Math.Min(i * ForecastGrid.Step, stop);
                tables[start + i] = speed * x + bend * x * x;
            }
        }
    }
}
